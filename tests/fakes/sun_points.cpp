// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fakes/sun_points.h"

#include "tests/fakes/chance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace boresight::fakes {
namespace {

using calibration::CalibrationPoint;
using pointing::PointingModel;
using pointing::PointingTerms;

constexpr double kLowest = 10.0;
constexpr double kHighest = 80.0;
constexpr double kFewestHours = 60.0;  // degrees of hour angle

double offAt(const PointingModel& hidden, const PointingModel& fitted, const SkyPointing& direction)
{
    const CalibrationPoint point{.axes = hidden.toAxes(direction).axes, .truth = direction};
    return calibration::offsetOf(point, fitted).size().degrees();
}

}  // namespace

SkyPointing SunDay::at(double hourAngle) const
{
    const double phi = Angle::fromDegrees(latitude).radians();
    const double delta = Angle::fromDegrees(declination).radians();
    const double hour = Angle::fromDegrees(hourAngle).radians();
    const double up = std::sin(phi) * std::sin(delta) + std::cos(phi) * std::cos(delta) * std::cos(hour);
    const double east = -std::cos(delta) * std::sin(hour);
    const double north = std::sin(delta) * std::cos(phi) - std::cos(delta) * std::sin(phi) * std::cos(hour);
    return {.azimuth = Angle::fromRadians(std::atan2(east, north)).wrapped360(),
            .elevation = Angle::fromRadians(std::asin(std::clamp(up, -1.0, 1.0)))};
}

std::vector<double> SunDay::hours() const
{
    std::vector<double> hours;
    for (double hour = -180.0; hour < 180.0; hour += 1.0) {
        const double elevation = at(hour).elevation.degrees();
        if (elevation > kLowest && elevation < kHighest) {
            hours.push_back(hour);
        }
    }
    return static_cast<double>(hours.size()) < kFewestHours ? std::vector<double>() : hours;
}

SunDay randomDay(std::mt19937_64& random)
{
    for (;;) {
        const SunDay day{.latitude = uniform(random, -60.0, 60.0), .declination = uniform(random, -23.4, 23.4)};
        if (!day.hours().empty()) {
            return day;
        }
    }
}

PointingTerms randomHidden(std::mt19937_64& random)
{
    const double tiltTo = uniform(random, 0.0, 2.0 * std::numbers::pi);
    PointingTerms terms;
    terms.azimuthOffset = 37.4_deg;
    terms.elevationOffset = Angle::fromDegrees(uniform(random, -1.0, 1.0));
    terms.tiltNorth = 0.6_deg * std::cos(tiltTo);
    terms.tiltEast = 0.6_deg * std::sin(tiltTo);
    terms.collimation = uniform(random, 0.0, 1.0) < 0.5 ? 0.3_deg : -0.3_deg;
    return terms;
}

std::vector<CalibrationPoint> sunPoints(const PointingTerms& hidden, const SunDay& day, int count, double noise,
                                        std::mt19937_64& random, Sides sides)
{
    const PointingModel model(hidden);
    const std::vector<double> hours = day.hours();
    std::vector<CalibrationPoint> points;
    for (int i = 0; i < count; ++i) {
        const double part = (i + uniform(random, 0.2, 0.8)) / count;
        const SkyPointing truth = day.at(hours[static_cast<std::size_t>(part * static_cast<double>(hours.size()))]);
        const bool overTheTop = sides == Sides::Both && i % 3 == 1;
        const SkyPointing aim = overTheTop ? SkyPointing{truth.azimuth + 180_deg, 180_deg - truth.elevation} : truth;
        AxisPosition axes = model.toAxes(aim).axes;
        axes.azimuth += Angle::fromDegrees(gaussian(random, noise) / std::cos(truth.elevation.radians()));
        axes.elevation += Angle::fromDegrees(gaussian(random, noise));
        points.push_back({.axes = axes,
                          .truth = truth,
                          .sigma = Angle::fromDegrees(noise),
                          .when = {},
                          .label = QStringLiteral("Sun")});
    }
    return points;
}

double worstOnArc(const PointingTerms& hidden, const PointingTerms& fitted, const SunDay& day)
{
    const PointingModel truth(hidden);
    const PointingModel model(fitted);
    double worst = 0.0;
    for (const double hour : day.hours()) {
        worst = std::max(worst, offAt(truth, model, day.at(hour)));
    }
    return worst;
}

double rmsOverSky(const PointingTerms& hidden, const PointingTerms& fitted)
{
    const PointingModel truth(hidden);
    const PointingModel model(fitted);
    double square = 0.0;
    int count = 0;
    for (int azimuth = 0; azimuth < 360; azimuth += 30) {
        for (int elevation = 10; elevation <= 70; elevation += 15) {
            const double off = offAt(truth, model, {Angle::fromDegrees(azimuth), Angle::fromDegrees(elevation)});
            square += off * off;
            ++count;
        }
    }
    return std::sqrt(square / count);
}

double northError(const PointingTerms& hidden, const PointingTerms& fitted)
{
    const PointingModel truth(hidden);
    const PointingModel model(fitted);
    double worst = 0.0;
    for (int azimuth = 0; azimuth < 360; azimuth += 15) {
        const AxisPosition axes = truth.toAxes({Angle::fromDegrees(azimuth), {}}).axes;
        const Angle off = (model.toSky(axes).azimuth - truth.toSky(axes).azimuth).wrapped180();
        worst = std::max(worst, std::abs(off.degrees()));
    }
    return worst;
}

}  // namespace boresight::fakes
