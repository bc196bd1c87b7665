// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/file_dialog.h"

#include <algorithm>

namespace boresight::ui {

namespace {

constexpr int kWidth = 640;  // px, at most

// "SVG drawing (*.svg)": svg
QString suffixOf(const QString& filter)
{
    return filter.section(QStringLiteral("*."), 1, 1).section(QLatin1Char(')'), 0, 0).section(QLatin1Char(' '), 0, 0);
}

}  // namespace

QFileDialog* askForFile(QWidget& owner, const QString& title, QFileDialog::AcceptMode mode, const QStringList& filters)
{
    auto* const dialog = new QFileDialog(&owner, title);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setOption(QFileDialog::DontUseNativeDialog);
    dialog->setAcceptMode(mode);
    dialog->setFileMode(mode == QFileDialog::AcceptSave ? QFileDialog::AnyFile : QFileDialog::ExistingFile);
    dialog->setNameFilters(filters);
    dialog->setDefaultSuffix(suffixOf(filters.front()));
    QObject::connect(dialog, &QFileDialog::filterSelected, dialog,
                     [dialog](const QString& filter) { dialog->setDefaultSuffix(suffixOf(filter)); });
    dialog->setModal(false);
    const QWidget& window = *owner.window();
    dialog->resize(std::min(window.width(), kWidth), window.height() / 2);
    dialog->move(window.mapToGlobal(QPoint(0, window.height() - dialog->height())));
    dialog->show();
    return dialog;
}

}  // namespace boresight::ui
