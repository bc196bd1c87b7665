// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/error_watch.h"

#include "core/budget/make_budget.h"
#include "core/orbit/element_age.h"
#include "core/pointing/missing_axis.h"
#include "core/units/angle_between.h"

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

using budget::BudgetFacts;
using budget::TargetOrigin;

// An older position is not live, neither here nor on the screen.
constexpr std::chrono::milliseconds kLiveWithin{500};

bool isLive(const StationStatus& status)
{
    return std::ranges::all_of(kAxes, [&](Axis axis) {
        const AxisStatus& one = axis == Axis::Azimuth ? status.azimuth : status.elevation;
        const bool isMissing = one.state == AxisState::Missing;
        return isMissing || (one.state != AxisState::NoData && one.age && *one.age < kLiveWithin);
    });
}

std::optional<Axis> missingOf(const Capabilities& can)
{
    const auto* const missing = std::ranges::find_if(kAxes, [&](Axis axis) { return !can.has(axis); });
    return missing == kAxes.end() ? std::nullopt : std::optional(*missing);
}

Angle apart(const SkyPointing& beam, const SkyPointing& place, std::optional<Axis> missing)
{
    return missing ? pointing::leastAngleBetween(beam, place, *missing) : angleBetween(beam, place);
}

// The place of an axis inside a step is anywhere with the same probability.
Angle resolutionOf(const Capabilities& can, Angle elevation)
{
    const auto step = [&can](Axis axis) { return can.has(axis) ? can.axes[index(axis)]->step.radians() : 0.0; };
    return Angle::fromRadians(std::hypot(step(Axis::Azimuth) * std::cos(elevation.radians()), step(Axis::Elevation)) /
                              std::sqrt(12.0));
}

// A target that is tracked without a known way is reported by another program.
TargetOrigin originOf(const StationStatus& status, const std::optional<tracking::StreamError>& stream)
{
    const bool isAzelFile = status.azel.phase != AzelPhase::Off && !status.azel.interpolates;
    if (status.tracked && status.tracked->isUp) {
        return isAzelFile || (!status.tracked->skyRate && !status.tracked->way) ? TargetOrigin::Reported
               : status.tracked->skyRate                                        ? TargetOrigin::Own
                                                                                : TargetOrigin::Fixed;
    }
    const bool isFollowed = stream && status.commander.kind == SourceKind::Client;
    return isFollowed ? TargetOrigin::Client : TargetOrigin::Fixed;
}

std::optional<budget::ElementFacts> elementFacts(const StationStatus& status)
{
    const auto& all = *status.satellites;
    const auto found = std::ranges::lower_bound(all, *status.tracked->number, {}, &orbit::ElementSet::number);
    if (found == all.end() || found->number != *status.tracked->number) {
        return std::nullopt;
    }
    const orbit::AgeError error = orbit::expectedError(*found, status.utc);
    return budget::ElementFacts{
        .age = Seconds(status.utc - orbit::utcTime(found->epoch)), .kilometres = error.kilometres, .time = error.time};
}

// The uncertainty of the terms in force as an angle on the sky. Without that of north it says too little.
std::optional<Angle> statedBy(const calibration::TermSheet& sheet, Angle elevation)
{
    if (!sheet.sigmas[indexOf(calibration::Term::AzimuthOffset)]) {
        return std::nullopt;
    }
    double squares = 0.0;
    for (const calibration::Term term : calibration::kAllTerms) {
        const double sigma = sheet.sigmas[indexOf(term)].value_or(Angle{}).radians();
        const double onSky = term == calibration::Term::AzimuthOffset ? sigma * std::cos(elevation.radians()) : sigma;
        squares += onSky * onSky;
    }
    return Angle::fromRadians(std::sqrt(squares));
}

budget::CalibrationFacts calibrationFacts(const CalibrationStatus& status, Angle elevation)
{
    budget::CalibrationFacts facts{.stated = statedBy(status.sheet, elevation)};
    for (const PointStatus& point : status.points) {
        if (point.isUsed) {
            facts.points.push_back({.residual = Angle::fromRadians(
                                        std::hypot(point.before.across.radians(), point.before.elevation.radians())),
                                    .sigma = point.sigma});
        }
    }
    return facts;
}

}  // namespace

std::optional<BudgetFacts> budgetFacts(const StationStatus& status, const std::optional<tracking::StreamError>& stream)
{
    if (!status.aimed || !status.actual || !status.commanded || !status.target || !isLive(status)) {
        return std::nullopt;
    }
    const Angle elevation = status.actual->elevation;
    BudgetFacts facts{
        .beamWidth = antennaOf(status).beamWidth,
        .resolution = resolutionOf(status.capabilities, elevation),
        .toTarget = apart(*status.commanded, pointing::upright(*status.target), missingOf(status.capabilities)),
        .origin = originOf(status, stream),
        .stream = stream,
        .clock = {.isSynchronised = status.clock.synchronised,
                  .error = status.clock.error,
                  .ahead = status.clock.ahead},
        .calibration = calibrationFacts(*status.calibration, elevation),
        .wind = {.isRead = !status.wind.source.isEmpty(),
                 .speed = status.wind.isSilent ? std::nullopt : status.wind.speed}};
    if (status.tracked) {
        facts.skyRate = status.tracked->skyRate;
        facts.isSatellite = status.tracked->number.has_value();
        facts.elements = facts.isSatellite ? elementFacts(status) : std::nullopt;
    }
    return facts;
}

void ErrorWatch::keep(const TickSample& sample, const Capabilities& can, const pointing::PointingModel& pointing)
{
    AxisPosition commanded;
    AxisPosition actual;
    for (const Axis axis : kAxes) {
        const AxisSample& one = sample.axes[index(axis)];
        if (!can.has(axis)) {
            continue;
        }
        if (!one.commanded || !one.actual) {
            return;
        }
        (axis == Axis::Azimuth ? commanded.azimuth : commanded.elevation) = *one.commanded;
        (axis == Axis::Azimuth ? actual.azimuth : actual.elevation) = *one.actual;
    }
    m_servo.add(sample.time, apart(pointing::upright(pointing.toSky(actual)),
                                   pointing::upright(pointing.toSky(commanded)), missingOf(can)));
}

void ErrorWatch::fill(StationStatus& status, const std::optional<tracking::StreamError>& stream, SteadyTime now) const
{
    if (auto facts = budgetFacts(status, stream)) {
        facts->servo = m_servo.summary(now);
        status.errorBudget = budget::makeBudget(*facts);
    }
}

}  // namespace boresight
