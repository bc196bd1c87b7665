// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/jog/rate_slider.h"

#include "ui/kit/command_button.h"
#include "ui/kit/theme.h"
#include "ui/look/paint.h"

#include <QMouseEvent>
#include <QPainter>
#include <QSignalBlocker>

#include <cmath>

namespace boresight::ui {

namespace {

constexpr int kPositions = 40;
constexpr int kPage = 8;
constexpr double kHandle = 24.0;  // px, across
constexpr double kGroove = 4.0;

// Two digits, as much as a person can distinguish: 0.24, 1.7.
double rounded(double degreesPerSecond)
{
    const double step = degreesPerSecond < 1.0 ? 0.01 : 0.1;
    return std::round(degreesPerSecond / step) * step;
}

}  // namespace

RateSlider::RateSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent)
{
    setRange(0, kPositions);
    setPageStep(kPage);
    setFocusPolicy(Qt::TabFocus);  // a click must not disarm the pad
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(this, &QSlider::valueChanged, this, [this] { Q_EMIT rateChosen(rate()); });
}

void RateSlider::setEnds(AngularRate slow, AngularRate fast)
{
    m_slow = slow;
    m_fast = fast;
}

void RateSlider::setRate(AngularRate rate)
{
    const double span = std::log(m_fast / m_slow);
    const double part = span > 0.0 ? std::log(rate / m_slow) / span : 0.0;
    const QSignalBlocker quiet(this);
    setValue(static_cast<int>(std::lround(part * kPositions)));
}

AngularRate RateSlider::rate() const
{
    if (value() == minimum()) {
        return m_slow;
    }
    if (value() == maximum()) {
        return m_fast;
    }
    const double factor = std::pow(m_fast / m_slow, static_cast<double>(value()) / kPositions);
    return AngularRate::fromDegrees(rounded(m_slow.degrees() * factor));
}

QSize RateSlider::sizeHint() const
{
    return {3 * kTouchSize, kTouchSize};
}

double RateSlider::pixel(int position) const
{
    return kHandle / 2.0 + 2.0 + (width() - kHandle - 4.0) * position / kPositions;
}

void RateSlider::moveTo(const QMouseEvent& event)
{
    const double part = (event.position().x() - pixel(0)) / (pixel(kPositions) - pixel(0));
    setValue(static_cast<int>(std::lround(part * kPositions)));
}

void RateSlider::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton) {
        setSliderDown(true);
        moveTo(*event);
    }
}

void RateSlider::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons().testFlag(Qt::LeftButton)) {
        moveTo(*event);
    }
}

void RateSlider::mouseReleaseEvent(QMouseEvent*)
{
    setSliderDown(false);
}

void RateSlider::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme& colours = currentTheme();
    const double middle = height() / 2.0;
    const QColor strong = isEnabled() ? colours.accent : colours.grid;
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.grid);
    painter.drawRoundedRect(QRectF(pixel(0), middle - kGroove / 2, pixel(kPositions) - pixel(0), kGroove), 2, 2);
    painter.setBrush(strong);
    painter.drawRoundedRect(QRectF(pixel(0), middle - kGroove / 2, pixel(value()) - pixel(0), kGroove), 2, 2);
    painter.setPen(QPen(strong, 2.0));
    painter.setBrush(colours.button);
    painter.drawEllipse(QPointF(pixel(value()), middle), kHandle / 2.0 - 1.0, kHandle / 2.0 - 1.0);
    if (hasFocus()) {
        paintFocus(painter, rect());
    }
}

}  // namespace boresight::ui

#include "moc_rate_slider.cpp"
