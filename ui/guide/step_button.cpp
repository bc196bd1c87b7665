// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guide/step_button.h"

#include "ui/guide/step_mark.h"
#include "ui/kit/command_button.h"
#include "ui/kit/theme.h"

#include <QAccessible>
#include <QPainter>

#include <algorithm>

namespace boresight::ui {

namespace {

constexpr int kStepButtonBar = 4;  // px, below the current step
constexpr int kMark = 11;          // px

}  // namespace

StepButton::StepButton(GuideStep step, Form form, QWidget* parent) : QAbstractButton(parent), m_step(step), m_form(form)
{
    setFont(fonts::label());
    setText(name(step));
    setCheckable(form == Form::OfTheRow);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    describe();
}

void StepButton::setNumber(int number)
{
    if (number != m_number) {
        m_number = number;
        describe();
        update();
    }
}

void StepButton::showReport(const StepReport& report)
{
    if (report.state == m_report.state && report.why == m_report.why) {
        return;
    }
    const bool changed = report.state != m_report.state;
    m_report = report;
    describe();
    update();
    if (changed) {
        QAccessibleEvent event(this, QAccessible::DescriptionChanged);
        QAccessible::updateAccessibility(&event);
    }
}

void StepButton::describe()
{
    const QString state = word(m_report.state);
    const QString text = m_report.why.isEmpty() ? state : tr("%1: %2").arg(state, m_report.why);
    setAccessibleName(m_form == Form::Line ? tr("Go to step %1: %2").arg(m_number).arg(name(m_step))
                                           : tr("Step %1: %2").arg(m_number).arg(name(m_step)));
    setAccessibleDescription(text);
    setToolTip(tr("%1\n%2").arg(title(m_step), text));
}

QSize StepButton::sizeHint() const
{
    if (m_form == Form::Line) {
        return {16 * fontMetrics().averageCharWidth(), kRowHeight};
    }
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
    painter.fillRect(rect(), isChecked() ? theme.plotGround : m_form == Form::Line ? theme.button : theme.window);
    m_form == Form::Line ? paintLine(painter) : paintInRow(painter);
    if (hasFocus()) {
        painter.setPen(theme.accent);
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

void StepButton::paintInRow(QPainter& painter) const
{
    const Theme& theme = currentTheme();
    const int line = fontMetrics().lineSpacing();
    const QColor colour = theme.colour(toneOf(m_report.state));
    const QString number = QString::number(m_number);
    const int wide = fontMetrics().horizontalAdvance(number);
    const QRect top((width() - wide - 4 - kMark) / 2, 4, wide, line);
    painter.setPen(isChecked() ? theme.text
                               : theme.colour(m_report.state == StepState::Open ? Tone::Normal : Tone::Secondary));
    painter.drawText(top, Qt::AlignCenter, number);
    painter.drawText(QRect(1, 4 + line, width() - 2, line), Qt::AlignCenter,
                     fontMetrics().elidedText(text(), Qt::ElideRight, width() - 2));
    drawStepMark(painter, m_report.state, QRectF(top.right() + 4, 4 + (line - kMark) / 2.0, kMark, kMark), colour);
    if (isChecked()) {
        painter.fillRect(QRect(4, height() - kStepButtonBar, width() - 8, kStepButtonBar), theme.accent);
    }
}

void StepButton::paintLine(QPainter& painter) const
{
    const Theme& theme = currentTheme();
    const QRect room = rect().adjusted(8, 0, -6, 0);
    drawStepMark(painter, m_report.state, QRectF(room.left(), (height() - kMark) / 2.0, kMark, kMark),
                 theme.colour(toneOf(m_report.state)));
    const QRect words = room.adjusted(kMark + 8, 0, 0, 0);
    painter.setPen(theme.text);
    painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter, tr("%1 %2").arg(m_number).arg(text()));
    painter.setPen(theme.colour(toneOf(m_report.state)));
    painter.drawText(words, Qt::AlignRight | Qt::AlignVCenter, word(m_report.state));
}

}  // namespace boresight::ui

#include "moc_step_button.cpp"
