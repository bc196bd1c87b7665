// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/advice.h"

#include "core/base/bus_name.h"
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/pointing/missing_axis.h"
#include "core/profile/commissioning.h"

namespace boresight::profile {
namespace {

// An axis that needs this long to stop and moves this far meanwhile cannot brake in time. A large dish may take long,
// and a fast mount may move far. Both together are probably a mistake.
constexpr Seconds kLongStop{3.0};
constexpr Angle kFarStop = Angle::fromDegrees(10.0);
// Full speed within five ticks. No antenna on a mast needs to start so fast.
constexpr Seconds kShortRamp{0.1};
// kg·m²: a Yagi of 2 m and 3 kg. Only a small rotator on a desk turns a lighter antenna.
constexpr double kLightAntenna = 2.0;

QString decimalText(double value, int decimals)
{
    return toQString(formatFixed(value, decimals));
}

// A stop from full speed with the acceleration of the profile. The averaging that limits the jerk adds its time.
struct Stop
{
    explicit Stop(const tracking::MotionLimits& limits)
    {
        const double speed = limits.speed.radians();
        const double acceleration = limits.acceleration.radians();
        const Seconds averaging{2.0 * acceleration / limits.jerk.radians()};
        const Seconds ramp{speed / acceleration};
        time = ramp + averaging;
        way = limits.speed * (0.5 * (ramp + averaging));
    }

    Seconds time{0.0};
    Angle way;
};

void adviseOn(std::vector<Advice>& list, const std::string& table, const QString& name, const AxisSettings& axis)
{
    const std::string key = table + ".max_acceleration_deg_s2";
    const tracking::MotionLimits& limits = axis.limits;
    const QString acceleration = decimalText(limits.acceleration.degrees(), 1);
    if (const Stop stop(limits); stop.time > kLongStop && stop.way > kFarStop) {
        list.push_back({key,
                        Text::tr("%1 needs %2 s and %3° to stop from %4°/s")
                            .arg(name, decimalText(stop.time.count(), 1), decimalText(stop.way.degrees(), 0),
                                 decimalText(limits.speed.degrees(), 1)),
                        Text::tr("Raise max_acceleration_deg_s2 (%1), or lower max_speed_deg_s.").arg(acceleration)});
    }
    const Seconds ramp{limits.speed.radians() / limits.acceleration.radians()};
    const double inertia = axis.maxTorque / limits.acceleration.radians();
    if (ramp < kShortRamp || inertia < kLightAntenna) {
        list.push_back({key,
                        Text::tr("%1 must reach %2°/s within %3 s. The permitted %4 Nm are enough for a moment of "
                                 "inertia of at most %5 kg·m², without friction and wind")
                            .arg(name, decimalText(limits.speed.degrees(), 1), decimalText(ramp.count(), 2),
                                 decimalText(axis.maxTorque, 1), decimalText(inertia, 1)),
                        Text::tr("Lower max_acceleration_deg_s2 (%1), or raise max_torque_nm.").arg(acceleration)});
    }
}

void adviseOnModel(std::vector<Advice>& list, const Profile& profile)
{
    const std::optional<Axis> missing = profile.missing();
    if (missing && pointing::withoutAxis(profile.pointing, *missing) != profile.pointing) {
        list.push_back({"pointing",
                        Text::tr("the mount has only one axis, so parts of its pointing model have no effect"),
                        Text::tr("Set tilt, collimation and the other terms of the missing axis to 0.")});
    }
}

void adviseOnHamlib(std::vector<Advice>& list, const Profile& profile)
{
    const auto bus = parseBusName(profile.bus);
    if (!profile.hamlibSettings.empty() && bus && bus->kind != BusKind::Hamlib && !namesNoBus(profile)) {
        list.push_back({"bus.hamlib_settings",
                        Text::tr("the settings of Hamlib have no effect, because Boresight starts no rotctld for %1")
                            .arg(toQString(profile.bus)),
                        Text::tr("Remove them, or give them to the rotctld that you start yourself, with its option "
                                 "-C.")});
    }
}

void adviseOnSteps(std::vector<Advice>& list, const std::string& table, const AxisSettings& axis)
{
    if (axis.stepsPerTurn > 0.0 && !kindOf(axis.driver).countsItself) {
        list.push_back({table + ".steps_per_turn", Text::tr("the steps have no effect, because this driver has none"),
                        Text::tr("Set %1.steps_per_turn to 0.").arg(toQString(table))});
    }
}

}  // namespace

std::vector<Advice> adviceOn(const Profile& profile)
{
    std::vector<Advice> list;
    adviseOn(list, "azimuth", Text::tr("the azimuth"), profile.azimuth);
    adviseOn(list, "elevation", Text::tr("the elevation"), profile.elevation);
    adviseOnModel(list, profile);
    adviseOnHamlib(list, profile);
    adviseOnSteps(list, "azimuth", profile.azimuth);
    adviseOnSteps(list, "elevation", profile.elevation);
    return list;
}

}  // namespace boresight::profile
