// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/replay/time_slider.h"

#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/theme.h"
#include "ui/look/paint.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QSignalBlocker>

#include <algorithm>

namespace boresight::ui {

namespace {

constexpr double kSliderHandle = 20.0;  // px, across
constexpr double kSliderGroove = 4.0;
constexpr double kMotionMark = 8.0;
constexpr int kLeastWidth = 160;

}  // namespace

TimeSlider::TimeSlider(UtcTime begin, UtcTime end, const std::vector<UtcTime>& marks, QWidget* parent)
    : QSlider(Qt::Horizontal, parent), m_begin(begin), m_end(end), m_moment(begin), m_marks(marks)
{
    setAccessibleName(tr("Moment of the recording"));
    setToolTip(tr("Press or drag to jump. ▲ marks the start of a motion. Keys: left and right 1 s, Home, End"));
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    // For a screen reader: whole seconds.
    setRange(0, static_cast<int>(std::chrono::duration_cast<std::chrono::seconds>(end - begin).count()));
}

QSize TimeSlider::sizeHint() const
{
    return {kLeastWidth, kTouchSize};
}

void TimeSlider::setMoment(UtcTime moment)
{
    m_moment = moment;
    const QSignalBlocker quiet(this);
    setValue(static_cast<int>(std::chrono::duration_cast<std::chrono::seconds>(moment - m_begin).count()));
    setAccessibleDescription(clockText(moment) + QLatin1Char('Z'));
    update();
}

double TimeSlider::pixelOf(UtcTime moment) const
{
    const double part = m_end > m_begin ? Seconds(moment - m_begin) / Seconds(m_end - m_begin) : 0.0;
    return kSliderHandle / 2.0 + part * (width() - kSliderHandle);
}

void TimeSlider::choose(double pixel)
{
    const double part = std::clamp((pixel - kSliderHandle / 2.0) / (width() - kSliderHandle), 0.0, 1.0);
    Q_EMIT momentChosen(m_begin + std::chrono::round<UtcTime::duration>(Seconds(m_end - m_begin) * part));
}

void TimeSlider::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme& colours = currentTheme();
    const double middle = height() / 2.0;
    const double at = pixelOf(m_moment);
    const auto groove = [&](double from, double to, const QColor& colour) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(colour);
        painter.drawRoundedRect(QRectF(from, middle - kSliderGroove / 2.0, to - from, kSliderGroove), 2.0, 2.0);
    };
    groove(kSliderHandle / 2.0, width() - kSliderHandle / 2.0, colours.grid);
    groove(kSliderHandle / 2.0, at, colours.accent);
    painter.setBrush(colours.text);
    for (const UtcTime mark : m_marks) {
        const QPointF tip(pixelOf(mark), middle + kSliderGroove);
        painter.drawPolygon(QPolygonF{tip, tip + QPointF(-kMotionMark / 2.0, kMotionMark),
                                      tip + QPointF(kMotionMark / 2.0, kMotionMark)});
    }
    painter.setBrush(colours.button);
    painter.setPen(QPen(colours.accent, 2.0));
    painter.drawEllipse(QPointF(at, middle), kSliderHandle / 2.0 - 2.0, kSliderHandle / 2.0 - 2.0);
    if (hasFocus()) {
        paintFocus(painter, QRectF(rect()).adjusted(1, 1, -1, -1));
    }
}

void TimeSlider::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton) {
        choose(event->position().x());
    }
}

void TimeSlider::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons().testFlag(Qt::LeftButton)) {
        choose(event->position().x());
    }
}

void TimeSlider::keyPressEvent(QKeyEvent* event)
{
    event->ignore();
}

}  // namespace boresight::ui

#include "moc_time_slider.cpp"
