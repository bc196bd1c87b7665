// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/commissioning.h"

#include "core/base/bus_name.h"
#include "core/pointing/missing_axis.h"
#include "core/pointing/pointing_model.h"
#include "core/profile/profile_diff.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <vector>

namespace boresight::profile {

namespace {

const std::string kSimulated = toString(BusName{});
// With tilts of a few degrees, each pass makes the remaining error at least ten times smaller.
constexpr int kNorthTimes = 4;

AxisSettings& settingsOf(Profile& profile, Axis axis)
{
    return axis == Axis::Azimuth ? profile.azimuth : profile.elevation;
}

TravelRange& limitsOf(Profile& profile, Axis axis)
{
    return axis == Axis::Azimuth ? profile.limits.azimuth : profile.limits.elevation;
}

Angle& parkOf(Profile& profile, Axis axis)
{
    return axis == Axis::Azimuth ? profile.park.azimuth : profile.park.elevation;
}

bool within(const TravelRange& inner, const TravelRange& outer)
{
    return inner.min >= outer.min && inner.max <= outer.max;
}

// Limits that are wider than the travel have no effect, so they stay unchanged.
void bringInside(Profile& profile, Axis axis)
{
    const TravelRange& travel = settingsOf(profile, axis).geometry.travel;
    TravelRange& limits = limitsOf(profile, axis);
    if (limits.max <= travel.min || limits.min >= travel.max) {
        limits = travel;
    }
    const TravelRange allowed{.min = std::max(limits.min, travel.min), .max = std::min(limits.max, travel.max)};
    parkOf(profile, axis) = allowed.clamped(parkOf(profile, axis));
}

// A hundredth of a degree is finer than any end of a cable, and the numbers in the file stay short.
Angle rounded(Angle angle)
{
    return Angle::fromDegrees(std::round(angle.degrees() * 100.0) / 100.0);
}

void shift(TravelRange& range, Angle by)
{
    range = {.min = rounded(range.min + by), .max = rounded(range.max + by)};
}

void leaveSimulatedSensor(Profile& profile)
{
    if (profile.sensor.source == SensorSource::Simulated) {
        profile.sensor.source = SensorSource::None;
    }
}

// Changes the ids of the axes to those of the controllers, if there are as many of them and an id of the profile does
// not answer. An axis without a controller keeps its id.
bool takeIds(Profile& profile, std::span<const int> ids)
{
    std::vector<int*> mine;
    for (AxisSettings* const axis : {&profile.azimuth, &profile.elevation}) {
        if (kindOf(axis->driver).hasId) {
            mine.push_back(&axis->id);
        }
    }
    const auto answers = [&ids](const int* id) { return std::ranges::find(ids, *id) != ids.end(); };
    const bool twice = ids.size() == 2 && ids[0] == ids[1];
    if (ids.size() != mine.size() || twice || std::ranges::all_of(mine, answers)) {
        return false;
    }
    for (std::size_t i = 0; i < mine.size(); ++i) {
        *mine[i] = ids[i];
    }
    return true;
}

void takeBus(Profile& profile, const std::string& bus)
{
    if (bus != profile.bus) {
        profile.bus = bus;
        profile.mount.directions = Directions::Unconfirmed;
        if (!namesNoBus(profile)) {
            leaveSimulatedSensor(profile);
        }
    }
}

bool isOfControllers(const std::string& bus)
{
    const auto name = parseBusName(bus);
    return name && (name->kind == BusKind::SocketCan || name->kind == BusKind::Fdcanusb);
}

// Values that were found at the previous mount are wrong for another mount.
void forgetTheMount(Profile& profile)
{
    std::vector<std::string> found = changedKeys(profile, Profile{});
    std::erase_if(found, [](const std::string& key) { return !isOfOneMount(key) || key == "bus.name"; });
    takeOver(profile, Profile{}, found);
    profile.mount.directions = Directions::Unconfirmed;
}

// The travel becomes the usual one, because it was that of the rotator. The speeds stay, so nothing becomes faster.
void leaveRotator(Profile& profile)
{
    for (const Axis axis : kAxes) {
        if (kindOf(profile.axis(axis).driver).countsItself) {
            AxisSettings& mine = settingsOf(profile, axis);
            const AxisSettings usual = Profile().axis(axis);
            mine.driver = AxisDriver::Moteus;
            mine.stepsPerTurn = usual.stepsPerTurn;
            setTravel(profile, axis, usual.geometry.travel);
            forgetTheMount(profile);
        }
    }
}

// Sets the values of common rotators. The operator enters the real ends and speeds later.
void becomeRotator(Profile& profile, Axis axis, AxisDriver driver)
{
    const bool azimuth = axis == Axis::Azimuth;
    AxisSettings& mine = settingsOf(profile, axis);
    mine.driver = driver;
    mine.limits = {.speed = AngularRate::fromDegrees(azimuth ? 6.0 : 2.5),
                   .acceleration = AngularAcceleration::fromDegrees(3.0),
                   .jerk = AngularJerk::fromDegrees(6.0)};
    setTravel(profile, axis, {.min = 0_deg, .max = azimuth ? 360_deg : 90_deg});
}

// 0: no model of Hamlib.
int hamlibModel(const std::string& bus)
{
    const auto name = parseBusName(bus);
    return name ? name->model : 0;
}

// True if controllers turn the axis and `driver` is a rotator with a control box.
bool becomesRotator(const Profile& profile, Axis axis, AxisDriver driver)
{
    const AxisDriver now = profile.axis(axis).driver;
    return now != driver && now != AxisDriver::None && !kindOf(now).countsItself;
}

}  // namespace

void useBus(Profile& profile, const std::string& bus, std::span<const int> ids)
{
    if (isOfControllers(bus)) {
        leaveRotator(profile);
    }
    if (takeIds(profile, ids)) {
        profile.mount.directions = Directions::Unconfirmed;
    }
    takeBus(profile, bus);
}

void useRotator(Profile& profile, const RotatorLine& line)
{
    const auto becomes = [&](Axis axis) { return becomesRotator(profile, axis, line.driver); };
    if (std::ranges::any_of(kAxes, becomes)) {
        forgetTheMount(profile);
    }
    for (const Axis axis : kAxes) {
        AxisSettings& mine = settingsOf(profile, axis);
        if (mine.driver == AxisDriver::None) {
            continue;
        }
        if (becomes(axis)) {
            becomeRotator(profile, axis, line.driver);
        } else if (mine.driver != line.driver) {  // the same rotator with another connection
            mine.driver = line.driver;
            profile.mount.directions = Directions::Unconfirmed;
        }
        mine.geometry.sign = 1;
        mine.geometry.offset = {};
    }
    if (!namesNoBus(profile) && hamlibModel(line.bus) != hamlibModel(profile.bus)) {
        profile.hamlibSettings.clear();
    }
    profile.baud = line.baud;
    takeBus(profile, line.bus);
}

bool namesNoBus(const Profile& profile)
{
    return profile.bus == kSimulated;
}

Profile withoutBus(Profile profile)
{
    profile.bus = kSimulated;
    return profile;
}

bool isOfOneMount(const std::string& key)
{
    static const std::vector<std::string> kKeys = {"bus.name",
                                                   "mount.directions",
                                                   "azimuth.offset_deg",
                                                   "elevation.offset_deg",
                                                   "rotator.sensor_offsets",
                                                   "sensor.azimuth_sense",
                                                   "sensor.azimuth_offset_deg",
                                                   "sensor.elevation_offset_deg"};
    return key.starts_with("pointing.") || key.starts_with("sensor.deviation_") ||
           std::ranges::find(kKeys, key) != kKeys.end();
}

bool losesAMount(const Profile& profile, AxisDriver driver)
{
    return std::ranges::any_of(kAxes, [&](Axis axis) {
        const pointing::AxisGeometry& mine = profile.axis(axis).geometry;
        const pointing::AxisGeometry usual = Profile().axis(axis).geometry;
        return becomesRotator(profile, axis, driver) &&
               (mine.offset != usual.offset || mine.sign != usual.sign || mine.travel != usual.travel ||
                profile.pointing != Profile().pointing);
    });
}

Profile forRealMount(Profile profile)
{
    forgetTheMount(profile);
    leaveSimulatedSensor(profile);
    return profile;
}

void swapMotors(Profile& profile)
{
    std::swap(profile.azimuth.id, profile.elevation.id);
    profile.mount.directions = Directions::Unconfirmed;
}

void reverse(Profile& profile, Axis axis, const std::optional<Angle>& reading)
{
    pointing::AxisGeometry& geometry = settingsOf(profile, axis).geometry;
    geometry.sign = -geometry.sign;
    if (reading) {
        geometry.offset = -geometry.offset - *reading * 2.0;  // sign × (reading + offset) stays the same
    }
    profile.mount.directions = Directions::Unconfirmed;
}

void setTravel(Profile& profile, Axis axis, const TravelRange& travel)
{
    settingsOf(profile, axis).geometry.travel = travel;
    bringInside(profile, axis);
}

void setReading(Profile& profile, Axis axis, Angle reading, Angle truth, Ends ends)
{
    pointing::AxisGeometry& geometry = settingsOf(profile, axis).geometry;
    const Angle by = truth - reading;
    geometry.offset -= by;
    if (ends == Ends::KeepTheirNumbers) {
        return;
    }
    TravelRange& limits = limitsOf(profile, axis);
    const bool limited = !within(geometry.travel, limits);
    shift(geometry.travel, by);
    if (limited) {
        shift(limits, by);
    }
    parkOf(profile, axis) = rounded(parkOf(profile, axis) + by);
    bringInside(profile, axis);
}

void setNorth(Profile& profile, const AxisPosition& axes, Angle trueAzimuth)
{
    pointing::PointingTerms& terms = profile.pointing;
    const std::optional<Axis> missing = profile.missing();
    // Repeated, because a tilt is given towards a true direction: with another azimuth offset, the tilt moves the beam
    // differently.
    for (int time = 0; time < kNorthTimes; ++time) {
        const pointing::PointingModel model(missing ? pointing::withoutAxis(terms, *missing) : terms);
        const Angle now = pointing::upright(model.toSky(axes)).azimuth;
        terms.azimuthOffset += (trueAzimuth - now).wrapped180();
    }
    if (abs(terms.azimuthOffset) > Angle::fromTurns(1.0)) {
        terms.azimuthOffset = terms.azimuthOffset.wrapped180();
    }
    terms.azimuthOffset = rounded(terms.azimuthOffset);
}

}  // namespace boresight::profile
