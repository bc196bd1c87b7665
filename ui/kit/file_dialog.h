// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFileDialog>

namespace boresight::ui {

// Asks for a file, or a folder, without stopping anything: not modal, in the lower half of the owner's window, so that
// STOP stays in reach and in sight. Shown already; it deletes itself when it is closed. A name without a suffix gets
// that of the chosen filter.
QFileDialog* askForFile(QWidget& owner, const QString& title, QFileDialog::AcceptMode mode, const QStringList& filters);
// Also one that is hidden; `folder` is shown first.
QFileDialog* askForFolder(QWidget& owner, const QString& title, const QString& folder);

}  // namespace boresight::ui
