// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/stop_button.h"

#include "ui/kit/theme.h"

#include <QPainter>

namespace boresight::ui {

namespace {

QPolygonF octagon(const QRectF& box)
{
    const double cut = box.height() * 0.29;  // of a regular octagon: 1 / (2 + sqrt 2)
    return QPolygonF({QPointF(box.left() + cut, box.top()), QPointF(box.right() - cut, box.top()),
                      QPointF(box.right(), box.top() + cut), QPointF(box.right(), box.bottom() - cut),
                      QPointF(box.right() - cut, box.bottom()), QPointF(box.left() + cut, box.bottom()),
                      QPointF(box.left(), box.bottom() - cut), QPointF(box.left(), box.top() + cut)});
}

}  // namespace

StopButton::StopButton(QWidget* parent) : QAbstractButton(parent)
{
    setText(tr("STOP"));
    setAccessibleName(tr("STOP"));
    setToolTip(
        tr("STOP (Esc, Pause or F12): the mount slows down and holds until \"Reset stop\".\n"
           "This is a function of the program. It does not replace the hard-wired emergency stop."));
    setAccessibleDescription(toolTip());
    QFont bold = fonts::state();
    bold.setBold(true);
    setFont(bold);
    setFocusPolicy(Qt::TabFocus);  // a press does not take the focus from an input field
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void StopButton::setPhase(Phase phase)
{
    if (phase != m_phase) {
        m_phase = phase;
        update();
    }
}

QSize StopButton::sizeHint() const
{
    const int lines = fontMetrics().height() + QFontMetrics(fonts::label()).height();
    return {std::max(150, fontMetrics().horizontalAdvance(text()) + 60), std::max(64, lines + 8)};
}

QString StopButton::phaseText() const
{
    switch (m_phase) {
        case Phase::Requested:
            return tr("requested");
        case Phase::Latched:
            return tr("latched");
        case Phase::Ready:
            break;
    }
    return {};
}

void StopButton::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme& colours = currentTheme();
    const QRectF box = QRectF(rect()).adjusted(1.5, 1.5, -1.5, -1.5);
    painter.setPen(QPen(isDown() ? colours.stopText : colours.stopOutline, 2.0));
    painter.setBrush(isDown() ? colours.stop.darker(125) : colours.stop);
    painter.drawPolygon(octagon(box));
    painter.setPen(colours.stopText);
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.drawPolygon(octagon(box.adjusted(4, 4, -4, -4)));
    }
    const QString phase = phaseText();
    const double small = phase.isEmpty() ? 0.0 : QFontMetricsF(fonts::label()).height();
    painter.drawText(box.adjusted(0, 0, 0, -small), Qt::AlignCenter, text());
    painter.setFont(fonts::label());
    painter.drawText(box.adjusted(0, 0, 0, -5), Qt::AlignHCenter | Qt::AlignBottom, phase);
}

}  // namespace boresight::ui

#include "moc_stop_button.cpp"
