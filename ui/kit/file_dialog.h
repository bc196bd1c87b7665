// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFileDialog>

namespace boresight::ui {

// Asks for a file or a folder. Not modal, and in the lower half of the owner's window, so that STOP stays visible and
// in reach. The dialog is shown already and deletes itself when it is closed. A name without a suffix gets that of the
// chosen filter.
QFileDialog* askForFile(QWidget& owner, const QString& title, QFileDialog::AcceptMode mode, const QStringList& filters);
// Hidden folders can be chosen, too. `folder` is shown first.
QFileDialog* askForFolder(QWidget& owner, const QString& title, const QString& folder);

}  // namespace boresight::ui
