// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolButton>

// A checkable button whose state is visible in every theme: the chosen one has a bar of the accent colour. A click
// gives it no focus, so that choosing a rate does not disarm the jog pad.
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
