// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

// Shown when a program cannot start and there is no terminal to print to: the complete reason, which can be selected
// and copied, what Boresight did, what to do, and a button that helps. Gui thread.
namespace boresight::ui {

class StartProblem : public QDialog
{
    Q_OBJECT

public:
    explicit StartProblem(const QString& reason, QWidget* parent = nullptr);

    // The profile to start with instead. Empty: the operator quits.
    [[nodiscard]] const QString& chosenProfile() const { return m_chosen; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void build(const QString& reason);
    void chooseProfile();

    QString m_chosen;
};

}  // namespace boresight::ui
