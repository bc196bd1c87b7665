// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/about_page.h"

#include "ui/kit/caption.h"
#include "ui/kit/theme.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QIcon>
#include <QLabel>
#include <QVBoxLayout>

namespace boresight::ui {

AboutPage::AboutPage(QWidget* parent) : QDialog(parent)
{
    setWindowTitle(tr("About Boresight"));
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(3 * kGrid, 2 * kGrid, 3 * kGrid, 2 * kGrid);
    column->setSpacing(kGrid);
    auto* const picture = new QLabel(this);
    picture->setPixmap(QIcon(QStringLiteral(":/boresight/icons/boresight.svg")).pixmap(8 * kGrid, 8 * kGrid));
    column->addWidget(picture);
    auto* const title = new QLabel(tr("Boresight %1").arg(QCoreApplication::applicationVersion()), this);
    title->setFont(fonts::state());
    column->addWidget(title);
    const auto addText = [&](const QString& caption, const QString& text) {
        column->addWidget(makeGroupCaption(caption, this));
        auto* const label = makeCaption(text, this);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        column->addWidget(label);
    };
    column->addWidget(makeCaption(tr("The controller of an antenna mount."), this));
    addText(tr("Licence"), tr("GNU General Public License, version 3 or later. There is no warranty."));
    addText(tr("Libraries"), tr("Qt %1, Qwt, Eigen, ERFA, libarchive, libexpected, libmosquitto, OpenSSL,\n"
                                "SDL 2, toml++")
                                 .arg(QLatin1String(qVersion())));
    auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    column->addWidget(buttons);
}

}  // namespace boresight::ui

#include "moc_about_page.cpp"
