// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMessageBox>

// What a program says that cannot start, when there is no terminal to say it in: the reason whole, to be selected and
// copied. Gui thread.
namespace boresight::ui {

class StartProblem : public QMessageBox
{
    Q_OBJECT

public:
    explicit StartProblem(const QString& reason, QWidget* parent = nullptr);
};

}  // namespace boresight::ui
