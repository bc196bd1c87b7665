// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/choice_button.h"

#include "ui/kit/command_button.h"
#include "ui/kit/theme.h"

#include <QPainter>

namespace boresight::ui {

namespace {
constexpr int kBar = 3;  // px
}

ChoiceButton::ChoiceButton(const QString& text, const QString& help, QWidget* parent) : QToolButton(parent)
{
    setFont(fonts::label());
    setText(text);
    setToolTip(help);
    setAccessibleName(help);
    setCheckable(true);
    setFocusPolicy(Qt::TabFocus);
    setMinimumSize(kTouchSize, kTouchSize);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void ChoiceButton::paintEvent(QPaintEvent* event)
{
    QToolButton::paintEvent(event);
    if (isChecked()) {
        QPainter painter(this);
        painter.fillRect(QRect(8, height() - kBar - 3, width() - 16, kBar), currentTheme().accent);
    }
}

}  // namespace boresight::ui

#include "moc_choice_button.cpp"
