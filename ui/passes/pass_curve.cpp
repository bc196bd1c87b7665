// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/pass_curve.h"

#include "ui/kit/format.h"
#include "ui/kit/theme.h"
#include "ui/look/pass_time_axis.h"
#include "ui/sky/sky_text.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace boresight::ui {

namespace {

// The top of the scale and the step of its lines, degrees: the lowest one that has room for the pass and its number.
struct Scale
{
    int top;
    int step;
};
constexpr Scale kScales[] = {{10, 5}, {20, 10}, {30, 10}, {60, 30}, {90, 30}};
constexpr double kRoomOfNumber = 0.9;  // of the scale is for the curve
constexpr double kLineWidth = 2.0;     // px
constexpr double kDot = 4.0;

const Scale& scaleFor(Angle highest)
{
    const auto* const found =
        std::ranges::find_if(kScales, [&](const Scale& one) { return highest.degrees() <= kRoomOfNumber * one.top; });
    return found == std::end(kScales) ? *(found - 1) : *found;
}

}  // namespace

PassCurve::PassCurve(QWidget* parent) : QWidget(parent)
{
    setFont(fonts::label());
    setAccessibleName(tr("Elevation over time"));
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Expanding);
}

void PassCurve::show(const targets::SkyWay& way)
{
    m_way = way && way->size() > 1 ? way : nullptr;
    describe();
    update();
}

void PassCurve::setLowest(const std::optional<Angle>& angle)
{
    if (angle != m_lowest) {
        m_lowest = angle;
        update();
    }
}

void PassCurve::setNow(UtcTime now)
{
    m_now = now;
    if (m_way) {
        update();
    }
}

void PassCurve::describe()
{
    setAccessibleDescription(m_way ? tr("From %1Z to %2Z, %3 high at %4Z")
                                         .arg(clockText(m_way->front().utc), clockText(m_way->back().utc),
                                              angleText(highest().direction.elevation, 0), clockText(highest().utc))
                                   : QString());
}

const targets::SkyMoment& PassCurve::highest() const
{
    return *std::ranges::max_element(*m_way, {}, [](const targets::SkyMoment& one) { return one.direction.elevation; });
}

QRectF PassCurve::canvas() const
{
    const double left = fontMetrics().horizontalAdvance(QStringLiteral("90°")) + 8.0;
    return QRectF(rect()).adjusted(left, fontMetrics().height() / 2.0 + 2.0, -14.0, -fontMetrics().height() - 10.0);
}

// A low pass has a smaller scale.
Angle PassCurve::top() const
{
    return Angle::fromDegrees(scaleFor(m_way ? highest().direction.elevation : 90_deg).top);
}

QPointF PassCurve::pixelOf(UtcTime utc, Angle elevation) const
{
    const QRectF box = canvas();
    return {timeAxis().pixelOf(utc), box.bottom() - box.height() * (elevation / top())};
}

PassTimeAxis PassCurve::timeAxis() const
{
    return {.first = m_way->front().utc, .last = m_way->back().utc, .canvas = canvas(), .room = double(width())};
}

// A segment is hidden if its end is hidden.
QPainterPath PassCurve::line(bool hidden) const
{
    QPainterPath path;
    for (std::size_t i = 1; m_way && i < m_way->size(); ++i) {
        const targets::SkyMoment& from = (*m_way)[i - 1];
        const targets::SkyMoment& to = (*m_way)[i];
        if (to.isHidden != hidden) {
            continue;
        }
        const QPointF begin = pixelOf(from.utc, from.direction.elevation);
        if (path.isEmpty() || path.currentPosition() != begin) {
            path.moveTo(begin);
        }
        path.lineTo(pixelOf(to.utc, to.direction.elevation));
    }
    return path;
}

std::optional<QPointF> PassCurve::place() const
{
    if (!m_way || m_now < m_way->front().utc || m_now > m_way->back().utc) {
        return std::nullopt;
    }
    const auto after = std::ranges::lower_bound(*m_way, m_now, {}, &targets::SkyMoment::utc);
    if (after == m_way->begin()) {
        return pixelOf(after->utc, after->direction.elevation);
    }
    const auto before = after - 1;
    const double part = Seconds(m_now - before->utc) / Seconds(after->utc - before->utc);
    return pixelOf(m_now,
                   before->direction.elevation + part * (after->direction.elevation - before->direction.elevation));
}

void PassCurve::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const Theme& colours = currentTheme();
    painter.setFont(font());
    painter.fillRect(rect(), colours.plotGround);
    if (!m_way) {
        painter.setPen(colours.secondary);
        painter.drawText(rect(), Qt::AlignCenter, tr("Select a pass first."));
        return;
    }
    paintGrid(painter);
    timeAxis().paint(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colours.secondary, kLineWidth, Qt::DotLine));
    painter.drawPath(line(true));
    painter.setPen(QPen(colours.accent, kLineWidth));
    painter.drawPath(line(false));
    paintMarks(painter);
}

void PassCurve::paintGrid(QPainter& painter) const
{
    const Theme& colours = currentTheme();
    const QRectF box = canvas();
    const Scale& scale = scaleFor(highest().direction.elevation);
    for (int degrees = 0; degrees <= scale.top; degrees += scale.step) {
        const double y = std::round(pixelOf(m_way->front().utc, Angle::fromDegrees(degrees)).y()) + 0.5;
        painter.setPen(colours.grid);
        painter.drawLine(QPointF(box.left(), y), QPointF(box.right(), y));
        painter.setPen(colours.secondary);
        const double half = fontMetrics().height() / 2.0;
        painter.drawText(QRectF(0.0, y - half, box.left() - 4.0, 2.0 * half), Qt::AlignRight | Qt::AlignVCenter,
                         QStringLiteral("%1°").arg(degrees));
    }
}

void PassCurve::paintMarks(QPainter& painter) const
{
    const Theme& colours = currentTheme();
    const QRectF box = canvas();
    if (m_lowest && *m_lowest > 0_deg && *m_lowest < top()) {
        const double y = pixelOf(m_way->front().utc, *m_lowest).y();
        painter.setPen(QPen(colours.secondary, 1.0, Qt::DashLine));
        painter.drawLine(QPointF(box.left(), y), QPointF(box.right(), y));
        const QString text = tr("from %1").arg(angleText(*m_lowest, 0));
        const QSizeF size(fontMetrics().horizontalAdvance(text) + 4.0, fontMetrics().height());
        drawOutlinedText(painter, {QPointF(box.right() - size.width(), y - size.height()), size}, text,
                         colours.secondary, colours.plotGround);
    }
    const targets::SkyMoment& most = highest();
    const QPointF peak = pixelOf(most.utc, most.direction.elevation);
    const QString text = angleText(most.direction.elevation, 0);
    const QSizeF size(fontMetrics().horizontalAdvance(text) + 4.0, fontMetrics().height());
    const double above = peak.y() - size.height() - 2.0;
    const double left = std::clamp(peak.x() - size.width() / 2.0, box.left(), box.right() - size.width());
    drawOutlinedText(painter, {QPointF(left, above < 0.0 ? peak.y() + 4.0 : above), size}, text, colours.text,
                     colours.plotGround);
    if (const auto now = place()) {
        painter.setPen(QPen(colours.text, 1.5));
        painter.drawLine(QPointF(now->x(), box.top()), QPointF(now->x(), box.bottom()));
        painter.setBrush(colours.accent);
        painter.drawEllipse(*now, kDot, kDot);
    }
}

}  // namespace boresight::ui

#include "moc_pass_curve.cpp"
