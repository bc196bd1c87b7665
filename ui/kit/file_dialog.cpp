// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/file_dialog.h"

#include <algorithm>

namespace boresight::ui {

namespace {

constexpr int kWidth = 640;  // px, at most

// From "SVG drawing (*.svg)" it returns svg.
QString suffixOf(const QString& filter)
{
    return filter.section(QStringLiteral("*."), 1, 1).section(QLatin1Char(')'), 0, 0).section(QLatin1Char(' '), 0, 0);
}

QFileDialog* makeDialog(QWidget& owner, const QString& title)
{
    auto* const dialog = new QFileDialog(&owner, title);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setOption(QFileDialog::DontUseNativeDialog);
    return dialog;
}

void showBelow(QFileDialog& dialog, const QWidget& owner)
{
    dialog.setModal(false);
    const QWidget& window = *owner.window();
    dialog.resize(std::min(window.width(), kWidth), window.height() / 2);
    dialog.move(window.mapToGlobal(QPoint(0, window.height() - dialog.height())));
    dialog.show();
}

}  // namespace

QFileDialog* askForFile(QWidget& owner, const QString& title, QFileDialog::AcceptMode mode, const QStringList& filters)
{
    auto* const dialog = makeDialog(owner, title);
    dialog->setAcceptMode(mode);
    dialog->setFileMode(mode == QFileDialog::AcceptSave ? QFileDialog::AnyFile : QFileDialog::ExistingFile);
    dialog->setNameFilters(filters);
    dialog->setDefaultSuffix(suffixOf(filters.front()));
    QObject::connect(dialog, &QFileDialog::filterSelected, dialog,
                     [dialog](const QString& filter) { dialog->setDefaultSuffix(suffixOf(filter)); });
    showBelow(*dialog, owner);
    return dialog;
}

QFileDialog* askForFolder(QWidget& owner, const QString& title, const QString& folder)
{
    auto* const dialog = makeDialog(owner, title);
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    dialog->setFilter(dialog->filter() | QDir::Hidden);  // some programs keep their settings there
    dialog->setDirectory(folder);
    showBelow(*dialog, owner);
    return dialog;
}

}  // namespace boresight::ui
