// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/sky_zoom.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace boresight::ui {

namespace {

constexpr double kMostMagnified = 90.0;  // 1° from the middle to the edge
constexpr double kSkyZoomStep = 1.25;
constexpr double kBeamWidthsInView = 5.0;  // from the middle to the edge
constexpr double kRingGap = 60.0;          // px between two lines of the grid, at least
constexpr double kSkyZoomSteps[] = {0.5, 1.0, 2.0, 5.0, 10.0, 30.0};

double stepFor(double pixelsPerDegree)
{
    for (const double step : kSkyZoomSteps) {
        if (step * pixelsPerDegree >= kRingGap) {
            return step;
        }
    }
    return kSkyZoomSteps[std::size(kSkyZoomSteps) - 1];
}

// Multiples of `step` in descending order, from `max` down to `min`.
std::vector<double> multiples(double step, double min, double max)
{
    std::vector<double> values;
    for (double number = std::floor(max / step + 1e-9); number * step >= min - 1e-9; number -= 1.0) {
        values.push_back(number * step);
    }
    return values;
}

QPointF offsetFromZenith(const SkyPointing& place, double radius)
{
    return SkyProjection{QPointF(), radius}.toPixel(place);
}

}  // namespace

void SkyZoom::toggle(Angle beamWidth)
{
    m_magnification = isOn() ? 1.0 : std::clamp(90_deg / (beamWidth * kBeamWidthsInView), 2.0, kMostMagnified);
}

void SkyZoom::step(int steps, Angle beamWidth)
{
    const double most = std::clamp(90_deg / beamWidth, 4.0, kMostMagnified);
    const double wanted = m_magnification * std::pow(kSkyZoomStep, steps);
    m_magnification = wanted < 1.1 ? 1.0 : std::min(wanted, most);
}

void SkyZoom::centreOn(const SkyPointing& place)
{
    m_centre = unflipped(place);
}

bool SkyZoom::follow(const SkyPointing& place)
{
    const QPointF way = offsetFromZenith(place, m_magnification) - offsetFromZenith(m_centre, m_magnification);
    if (std::hypot(way.x(), way.y()) <= 0.5) {
        return false;
    }
    centreOn(place);
    return isOn();
}

SkyProjection SkyZoom::projection(const SkyProjection& whole) const
{
    if (!isOn()) {
        return whole;
    }
    const double radius = std::round(whole.radius * m_magnification);  // Qwt draws circles with whole pixels
    return {.zenith = whole.zenith - offsetFromZenith(m_centre, radius), .radius = radius};
}

SkyGrid wholeSkyGrid()
{
    return {.azimuths = multiples(30.0, 0.0, 330.0), .elevations = {60.0, 30.0}};
}

SkyGrid gridOf(const SkyProjection& sky, const QRectF& view)
{
    const QPointF middle = view.center() - sky.zenith;
    const double perDegree = sky.radius / 90.0;
    const double away = std::hypot(middle.x(), middle.y());
    const double reach = std::hypot(view.width(), view.height()) / 2.0;
    const double ringStep = stepFor(perDegree);
    SkyGrid grid;
    grid.elevations = multiples(ringStep, std::max(90.0 - (away + reach) / perDegree, 0.0),
                                std::min(90.0 - std::max(away - reach, 0.0) / perDegree, 90.0));
    std::erase_if(grid.elevations, [](double elevation) { return elevation <= 0.0 || elevation >= 90.0; });
    grid.decimals = ringStep < 1.0 ? 1 : 0;
    if (away <= reach) {
        grid.azimuths = multiples(30.0, 0.0, 330.0);
        return grid;
    }
    const double step = stepFor(away * std::numbers::pi / 180.0);
    const double towards = sky.toSky(view.center()).azimuth.degrees();
    const double aside = std::asin(reach / away) * 180.0 / std::numbers::pi;
    for (const double azimuth : multiples(step, towards - aside, towards + aside)) {
        grid.azimuths.push_back(azimuth - 360.0 * std::floor(azimuth / 360.0));
    }
    std::ranges::sort(grid.azimuths, std::greater());
    grid.decimals = std::min(ringStep, step) < 1.0 ? 1 : 0;
    return grid;
}

}  // namespace boresight::ui
