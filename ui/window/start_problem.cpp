// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/start_problem.h"

namespace boresight::ui {

StartProblem::StartProblem(const QString& reason, QWidget* parent)
    : QMessageBox(QMessageBox::Critical, tr("Boresight cannot start"), reason, QMessageBox::Ok, parent)
{
    setTextFormat(Qt::PlainText);  // a file's own words are in it
    setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
}

}  // namespace boresight::ui

#include "moc_start_problem.cpp"
