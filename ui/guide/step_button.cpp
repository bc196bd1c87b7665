// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guide/step_button.h"

#include "ui/kit/command_button.h"
#include "ui/kit/theme.h"

#include <QPainter>

namespace boresight::ui {

namespace {
constexpr int kStepButtonBar = 4;  // px, under the step that is shown
}

StepButton::StepButton(GuideStep step, int number, QWidget* parent)
    : QAbstractButton(parent), m_step(step), m_number(number)
{
    setFont(fonts::label());
    setText(name(step));
    setCheckable(true);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Step %1: %2").arg(number).arg(name(step)));
    describe();
}

void StepButton::setState(StepState state)
{
    if (state != m_state) {
        m_state = state;
        describe();
        update();
    }
}

void StepButton::describe()
{
    const QString word = m_state == StepState::Done    ? tr("done")
                         : m_state == StepState::Later ? tr("later")
                                                       : tr("to do");
    setToolTip(tr("%1 (%2)").arg(title(m_step), word));
    setAccessibleDescription(word);
}

QSize StepButton::sizeHint() const
{
    return {fontMetrics().horizontalAdvance(text()) + 8, std::max(kTouchSize, 2 * fontMetrics().lineSpacing() + 12)};
}

QSize StepButton::minimumSizeHint() const
{
    return {kTouchSize, sizeHint().height()};
}

void StepButton::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    const Theme& theme = currentTheme();
    const int line = fontMetrics().lineSpacing();
    // "✓" done, "›" later, nothing while it is to do.
    const QString mark = m_state == StepState::Done    ? QStringLiteral(" ✓")
                         : m_state == StepState::Later ? QStringLiteral(" ›")
                                                       : QString();
    painter.fillRect(rect(), isChecked() ? theme.plotGround : theme.window);
    painter.setPen(isChecked() || m_state == StepState::Open ? theme.text : theme.secondary);
    const QRect top(2, 4, width() - 4, line);
    painter.drawText(top, Qt::AlignCenter, QString::number(m_number) + mark);
    painter.drawText(top.translated(0, line), Qt::AlignCenter,
                     fontMetrics().elidedText(text(), Qt::ElideRight, width() - 4));
    if (isChecked()) {
        painter.fillRect(QRect(4, height() - kStepButtonBar, width() - 8, kStepButtonBar), theme.accent);
    }
    if (hasFocus()) {
        painter.setPen(theme.accent);
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

}  // namespace boresight::ui

#include "moc_step_button.cpp"
