// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/swing_plan.h"

#include "core/base/text.h"
#include "core/calibration/compass_swing.h"
#include "core/cross_check/sensor_check.h"
#include "core/units/degrees_text.h"

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

constexpr AngularRate kSlowest = AngularRate::fromDegrees(0.5);
constexpr AngularRate kFastest = calibration::kFastestSwing;
constexpr int kFewestHeadings = 8;
constexpr int kMostHeadings = 72;
// A smaller arc does not show even the first harmonic reliably (core/calibration, fitCompassSwing).
constexpr Angle kLeastArc = Angle::fromDegrees(210.0);
constexpr Angle kCircle = Angle::fromDegrees(360.0);
// Distance to the ends of the free travel: the swing turns back before a limit stops it.
constexpr Angle kMargin = Angle::fromDegrees(1.0);
// Below this elevation the box measures the tilt badly, and the curve is measured far from the elevations of most
// satellite passes.
constexpr Angle kWellForTilt = Angle::fromDegrees(20.0);

// At most one full circle of the free travel, as near around the present position as possible.
TravelRange arcAround(Angle here, const TravelRange& free)
{
    const TravelRange inside{.min = free.min + kMargin, .max = free.max - kMargin};
    if (inside.max - inside.min <= kCircle) {
        return inside;
    }
    const Angle from = std::clamp(here - kCircle / 2.0, inside.min, inside.max - kCircle);
    return {.min = from, .max = from + kCircle};
}

QString obstacleOf(const SwingWish& wish, const SwingPlan& plan)
{
    if (!(wish.rate >= kSlowest && wish.rate <= kFastest)) {
        return Text::tr("The rate of a swing must be %1 to %2°/s.")
            .arg(kSlowest.degrees(), 0, 'f', 1)
            .arg(kFastest.degrees(), 0, 'f', 1);
    }
    if (wish.headings != 0 && (wish.headings < kFewestHeadings || wish.headings > kMostHeadings)) {
        return Text::tr("A swing has %1 to %2 stops, or none.").arg(kFewestHeadings).arg(kMostHeadings);
    }
    if (const QString obstacle = compassObstacle(plan.elevation); !obstacle.isEmpty()) {
        return obstacle;
    }
    if (plan.azimuth.max - plan.azimuth.min < kLeastArc) {
        return Text::tr("Only %1 of azimuth is free at this elevation. A swing needs %2. Raise the boom.")
            .arg(degreesText(std::max(plan.azimuth.max - plan.azimuth.min, Angle{}), 0), degreesText(kLeastArc, 0));
    }
    return {};
}

// Advice about the elevation of the boom.
QString adviceFor(Angle elevation)
{
    const calibration::LevelLimits limits = levelLimits();
    if (elevation < limits.lowest || elevation > limits.highest) {
        return Text::tr("no tilt at this elevation (it is measured between %1 and %2, best at 30°)")
            .arg(degreesText(limits.lowest, 0), degreesText(limits.highest, 0));
    }
    return elevation < kWellForTilt ? Text::tr("raise the boom to 30° first for the best tilt and curve") : QString();
}

QString textOf(const SwingPlan& plan)
{
    const QString where =
        Text::tr("azimuth axis from %1 to %2 and back, elevation stays at %3")
            .arg(degreesText(plan.azimuth.min, 0), degreesText(plan.azimuth.max, 0), degreesText(plan.elevation, 0));
    const QString how = plan.headings == 0 ? Text::tr("at %1°/s").arg(plan.rate.degrees(), 0, 'f', 1)
                                           : Text::tr("with %1 stops each way").arg(plan.headings);
    const int seconds = static_cast<int>(std::ceil(plan.duration.count()));
    const QString advice = adviceFor(plan.elevation);
    return QStringLiteral("%1, %2, %3%4")
        .arg(where, how, Text::tr("about %1 min %2 s").arg(seconds / 60).arg(seconds % 60, 2, 10, QLatin1Char('0')),
             advice.isEmpty() ? QString() : QStringLiteral("; ") + advice);
}

// The time at full speed, plus one second for starting and stopping.
Seconds wayTime(Angle way, const tracking::MotionLimits& limits)
{
    return Seconds(std::abs(way.radians()) / limits.speed.radians() + 1.0);
}

Seconds durationOf(const SwingPlan& plan, const AxisPosition& here, const tracking::MotionLimits& limits)
{
    const Angle arc = plan.azimuth.max - plan.azimuth.min;
    const Angle nearest = std::min(abs(here.azimuth - plan.azimuth.min), abs(here.azimuth - plan.azimuth.max));
    Seconds time = wayTime(nearest, limits);
    if (plan.headings == 0) {
        return time + Seconds(2.0 * (arc.radians() / plan.rate.radians()) + 2.0);
    }
    const auto stops = stopsOf(plan);
    for (std::size_t i = 1; i < stops.size(); ++i) {
        time += wayTime(stops[i] - stops[i - 1], limits);
    }
    return time + kSwingDwell * static_cast<double>(stops.size());
}

}  // namespace

calibration::LevelLimits levelLimits()
{
    return {.highest = kHighestForCompass};
}

QString compassObstacle(Angle elevation)
{
    if (abs(elevation) <= kHighestForCompass) {
        return {};
    }
    return Text::tr("With the boom at %1 the compass does not work. Lower it to %2 or less, best to 30°.")
        .arg(degreesText(elevation, 0), degreesText(kHighestForCompass, 0));
}

Angle stoppingWay(AngularRate rate, const tracking::MotionLimits& limits)
{
    const double v = std::abs(rate.radians());
    const double a = limits.acceleration.radians();
    return Angle::fromRadians(v * v / (2.0 * a) + v * a / limits.jerk.radians());
}

std::vector<Angle> stopsOf(const SwingPlan& plan)
{
    // A whole circle ends where it began, so its last heading is one step before the end.
    const Angle arc = plan.azimuth.max - plan.azimuth.min;
    const bool whole = arc >= kCircle - Angle::fromDegrees(0.01);
    const Angle step = arc / (whole ? plan.headings : plan.headings - 1);
    std::vector<Angle> stops;
    for (int i = 0; i < plan.headings; ++i) {
        stops.push_back(plan.azimuth.min + step * i);
    }
    std::vector<Angle> back(stops.rbegin(), stops.rend());
    stops.insert(stops.end(), back.begin(), back.end());
    return stops;
}

SwingPlan planSwing(const SwingWish& wish, const AxisPosition& here, const pointing::PermittedRegion& region,
                    const tracking::MotionLimits& limits)
{
    SwingPlan plan{.elevation = here.elevation, .rate = std::min(wish.rate, limits.speed), .headings = wish.headings};
    if (!region.permits(here)) {
        plan.obstacle = Text::tr("The mount is outside the permitted region. Jog it back inside first.");
        return plan;
    }
    plan.azimuth = arcAround(here.azimuth, region.azimuthsAround(pointing::AxisBox::at(here)));
    plan.obstacle = obstacleOf(wish, plan);
    if (plan.obstacle.isEmpty()) {
        plan.duration = durationOf(plan, here, limits);
        plan.text = textOf(plan);
    }
    return plan;
}

}  // namespace boresight
