// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/cable_ring.h"

#include "ui/kit/axes.h"
#include "ui/kit/format.h"
#include "ui/kit/theme.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace boresight::ui {

namespace {

// width of the track as a part of the pitch of the spiral: the rest is the gap to the next turn
constexpr double kWidthOfPitch = 0.72;
constexpr Angle kHatchedEnd = Angle::fromDegrees(9.0);
constexpr Angle kHatchStep = Angle::fromDegrees(1.5);
constexpr Angle kArcStep = Angle::fromDegrees(1.0);
constexpr Angle kNoticeable = Angle::fromDegrees(3.0);  // a destination nearer than this is hidden by the dot
constexpr double kDotMargin = 2.5;                      // px of the dot outside the track

}  // namespace

CableState cableOf(const StationStatus& status)
{
    if (missingAxis(status) == Axis::Azimuth || hasXY(status)) {
        return {};
    }
    const AxisStatus& axis = status.azimuth;
    const Freshness age = freshness(axis.age);
    CableState cable{
        .travel = axis.travel, .zero = termsOf(status).azimuthOffset, .wrapKnown = isTurnKnown(status, Axis::Azimuth)};
    cable.late = age == Freshness::Late;
    if (age != Freshness::NoData && cable.wrapKnown) {
        cable.actual = axis.actual;
        cable.destination = status.slew || status.state == StationState::Slew ? axis.target : std::nullopt;
    }
    return cable;
}

CableRing::CableRing(const SkyFrame& frame, const TravelRange& travel, Angle zero)
    : m_frame(frame), m_travel(travel), m_zero(zero), m_width(frame.widestTrack())
{
    if (isSpiral()) {
        const double pitch = (frame.outerTrack() - frame.innerTrack()) / (m_travel.max - m_travel.min).turns();
        m_width = std::min(m_width, kWidthOfPitch * pitch);
    }
}

double CableRing::radius(Angle angle) const
{
    if (!isSpiral()) {
        return (m_frame.innerTrack() + m_frame.outerTrack()) / 2.0;
    }
    const double part = (angle - m_travel.min) / (m_travel.max - m_travel.min);
    return m_frame.innerTrack() + part * (m_frame.outerTrack() - m_frame.innerTrack());
}

QPointF CableRing::pixel(Angle angle) const
{
    return m_frame.sky().zenith + radius(angle) * outwards(angle);
}

QPointF CableRing::outwards(Angle angle) const
{
    const double azimuth = (angle + m_zero).radians();
    return {std::sin(azimuth), -std::cos(azimuth)};
}

QPainterPath CableRing::arc(Angle from, Angle to) const
{
    const int steps = std::max(1, static_cast<int>(std::ceil(abs(to - from) / kArcStep)));
    QPolygonF line;
    for (int step = 0; step <= steps; ++step) {
        line << pixel(from + (to - from) * (double(step) / steps));
    }
    QPainterPath path;
    path.addPolygon(line);
    return path;
}

QRectF CableRing::dotBox(Angle angle) const
{
    const double half = m_width / 2.0 + kDotMargin;
    const QPointF centre = pixel(m_travel.clamped(angle));
    return {centre.x() - half, centre.y() - half, 2.0 * half, 2.0 * half};
}

// Slanted strokes across the track. A pattern of the painter is too coarse for such a thin band.
void CableRing::hatch(QPainter& painter, Angle from, Angle to) const
{
    const QPointF zenith = m_frame.sky().zenith;
    const auto beside = [&](Angle angle, double offset) {
        const QPointF away = pixel(angle) - zenith;
        return zenith + away * (1.0 + offset / std::hypot(away.x(), away.y()));
    };
    painter.setPen(QPen(currentTheme().secondary, 1.0));
    const int strokes = static_cast<int>((to - from) / kHatchStep);
    for (int stroke = 0; stroke < strokes; ++stroke) {
        const Angle angle = from + stroke * kHatchStep;
        painter.drawLine(beside(angle, -m_width / 2.0), beside(angle + kHatchStep * 0.6, m_width / 2.0));
    }
}

// The part that the axis cannot reach: all of it if it is a part of the ring, else a short piece beyond each end.
void CableRing::paintEnds(QPainter& painter) const
{
    const Angle closed = Angle::fromTurns(1.0) - (m_travel.max - m_travel.min);
    if (closed > 0_deg) {
        hatch(painter, m_travel.max, m_travel.max + closed);
    } else if (isSpiral()) {
        hatch(painter, m_travel.min - kHatchedEnd, m_travel.min);
        hatch(painter, m_travel.max, m_travel.max + kHatchedEnd);
    }
    painter.setPen(QPen(currentTheme().text, 1.5));
    for (const Angle end : {m_travel.min, m_travel.max}) {
        const QPointF away = outwards(end);
        painter.drawLine(pixel(end) - away * (m_width / 2.0 + 1.5), pixel(end) + away * (m_width / 2.0 + 1.5));
    }
}

void CableRing::paintTrack(QPainter& painter, bool wrapKnown) const
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    const Theme& colours = currentTheme();
    QPen pen(colours.grid, m_width, Qt::SolidLine, Qt::FlatCap);
    if (!wrapKnown) {
        pen.setDashPattern({1.5, 1.5});
    }
    painter.setPen(pen);
    painter.drawPath(arc(m_travel.min, m_travel.max));
    if (wrapKnown) {
        const Angle zone = std::min(kCableWarning, (m_travel.max - m_travel.min) * 0.25);
        QPen striped(colours.warning, m_width, Qt::CustomDashLine, Qt::FlatCap);  // the red theme has only one colour
        striped.setDashPattern({2.5, 0.6});
        painter.setPen(striped);
        painter.drawPath(arc(m_travel.min, m_travel.min + zone));
        painter.drawPath(arc(m_travel.max - zone, m_travel.max));
    }
    paintEnds(painter);
    painter.restore();
}

void CableRing::paintCable(QPainter& painter, const CableState& cable) const
{
    if (!cable.isThere() || !cable.actual) {
        return;
    }
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    const Theme& colours = currentTheme();
    const QColor colour = cable.late ? colours.secondary : colours.accent;
    const Angle actual = m_travel.clamped(*cable.actual);
    painter.setPen(QPen(colour, m_width, Qt::SolidLine, Qt::FlatCap));
    painter.drawPath(arc(m_travel.clamped(0_deg), actual));
    if (cable.destination && abs(*cable.destination - actual) > kNoticeable) {
        painter.setPen(QPen(colour, 1.5));
        painter.setBrush(colours.window);
        painter.drawEllipse(dotBox(*cable.destination).adjusted(1, 1, -1, -1));
    }
    painter.setPen(QPen(colours.window, 1.5));
    painter.setBrush(colour);
    painter.drawEllipse(dotBox(actual));
    painter.restore();
}

QRegion CableRing::changed(const CableState& before, const CableState& after) const
{
    QRegion region;
    if (before == after) {
        return region;
    }
    const auto add = [&](const QRectF& box) {
        const double room = m_width / 2.0 + kDotMargin + 2.0;
        region += box.adjusted(-room, -room, room, room).toAlignedRect();
    };
    const auto of = [&](const std::optional<Angle>& angle) { return m_travel.clamped(angle.value_or(0_deg)); };
    if (before.late != after.late || before.actual.has_value() != after.actual.has_value()) {
        add(arc(m_travel.min, m_travel.max).boundingRect());
        return region;
    }
    add(arc(of(before.actual), of(after.actual)).boundingRect());
    if (before.destination != after.destination) {
        add(QRectF(pixel(of(before.destination)), QSizeF(0, 0)));
        add(QRectF(pixel(of(after.destination)), QSizeF(0, 0)));
    }
    return region;
}

}  // namespace boresight::ui
