// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolButton>

// A checkable button whose choice is seen in every theme: a bar of the accent colour under the chosen one. It takes no
// focus from a click, so that choosing a rate does not disarm the jog pad.
namespace boresight::ui {

class ChoiceButton : public QToolButton
{
    Q_OBJECT

public:
    ChoiceButton(const QString& text, const QString& help, QWidget* parent = nullptr);

protected:
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace boresight::ui
