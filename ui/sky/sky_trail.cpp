// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/sky_trail.h"

#include "ui/kit/theme.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace boresight::ui {

namespace {

constexpr Angle kTrailGap = 6_deg;     // three times the motion of the fastest mount in one update
constexpr Angle kTrailStep = 0.2_deg;  // finer than a pixel of any screen
constexpr std::chrono::minutes kTrailAge{15};
constexpr std::chrono::minutes kForgetEvery{1};
constexpr std::chrono::seconds kFadeTime{60};
constexpr std::chrono::seconds kFadeStep{1};
constexpr std::size_t kTrailLength = 20000;  // 15 minutes of continuous motion at 4°/s
constexpr double kFaint = 0.15;
constexpr double kTrailWidth = 1.8;  // px

// Accurate enough for small angles, also near the zenith.
Angle separation(const SkyPointing& a, const SkyPointing& b)
{
    const double east = (a.azimuth - b.azimuth).wrapped180().radians() * std::cos(a.elevation.radians());
    const double up = (a.elevation - b.elevation).radians();
    return Angle::fromRadians(std::hypot(east, up));
}

QRect paintedBox(const QRectF& box)
{
    return box.adjusted(-3, -3, 3, 3).toAlignedRect();
}

QColor faded(QColor colour, double strength)
{
    colour.setAlphaF(static_cast<float>(strength));
    return colour;
}

}  // namespace

void SkyTrail::setSky(const SkyProjection& sky)
{
    m_sky = sky;
    rebuild();
}

QRect SkyTrail::add(const SkyPointing& place, UtcTime utc)
{
    const SkyPointing direction = unflipped(place);
    if (!m_places.empty() && separation(direction, m_places.back().direction) < kTrailStep) {
        return {};
    }
    const QPointF before = m_pixels.currentPosition();
    append(direction, utc);
    if (m_places.size() > kTrailLength) {
        m_places.erase(m_places.begin(), m_places.begin() + kTrailLength / 8);
        rebuild();
    }
    return paintedBox(QRectF(before, m_pixels.currentPosition()).normalized());
}

void SkyTrail::append(const SkyPointing& direction, UtcTime utc)
{
    const QPointF pixel = m_sky.toPixel(direction);
    const bool begins = m_places.empty() || separation(direction, m_places.back().direction) >= kTrailGap;
    if (begins) {
        m_pixels.moveTo(pixel);
    } else {
        m_pixels.lineTo(pixel);
    }
    m_places.push_back({direction, utc, pixel, begins});
}

// Old points are removed for a whole minute at a time, because the line is then built again.
QRect SkyTrail::age(UtcTime utc)
{
    m_now = utc;
    QRect changed;
    if (!m_places.empty() && (utc - m_painted >= kFadeStep || utc < m_painted)) {
        const UtcTime faintSince = m_painted - kFadeTime;
        m_painted = utc;
        for (auto one = m_places.rbegin(); one != m_places.rend() && one->utc >= faintSince; ++one) {
            changed |= paintedBox(QRectF(one->pixel, QSizeF(0, 0)));
        }
    }
    if (!m_places.empty() && utc - m_places.front().utc >= kTrailAge + kForgetEvery) {
        changed |= paintedBox(m_pixels.boundingRect());
        const auto young = std::ranges::find_if(m_places, [&](const Place& one) { return utc - one.utc < kTrailAge; });
        m_places.erase(m_places.begin(), young);
        rebuild();
    }
    return changed;
}

QRect SkyTrail::replace(const std::vector<SeenPlace>& places, UtcTime utc)
{
    QRect changed = paintedBox(m_pixels.boundingRect());
    m_places.clear();
    m_pixels.clear();
    m_now = utc;
    m_painted = utc;
    for (const SeenPlace& place : places) {
        add(place.direction, place.utc);
    }
    changed |= paintedBox(m_pixels.boundingRect());
    return changed;
}

double SkyTrail::strength(UtcTime utc) const
{
    const double part = Seconds(m_now - utc) / Seconds(kFadeTime);
    return 1.0 - (1.0 - kFaint) * std::clamp(part, 0.0, 1.0);
}

void SkyTrail::rebuild()
{
    m_pixels.clear();
    std::deque<Place> places;
    std::swap(places, m_places);
    for (const Place& one : places) {
        append(one.direction, one.utc);
    }
}

std::deque<SkyTrail::Place>::const_iterator SkyTrail::lastMinute() const
{
    return std::ranges::find_if(m_places, [&](const Place& one) { return m_now - one.utc < kFadeTime; });
}

void SkyTrail::paint(QPainter& painter) const
{
    const QColor colour = currentTheme().text;
    const auto young = lastMinute();
    QPainterPath faint;
    for (auto one = m_places.begin(); one != young; ++one) {
        if (one->begins) {
            faint.moveTo(one->pixel);
        } else {
            faint.lineTo(one->pixel);
        }
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(faded(colour, kFaint), kTrailWidth));
    painter.drawPath(faint);
    for (auto one = young; one != m_places.end(); ++one) {
        if (one != m_places.begin() && !one->begins) {
            painter.setPen(QPen(faded(colour, strength(one->utc)), kTrailWidth, Qt::SolidLine, Qt::FlatCap));
            painter.drawLine(std::prev(one)->pixel, one->pixel);
        }
    }
}

}  // namespace boresight::ui
