// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/advice.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/pointing/missing_axis.h"

namespace boresight::profile {
namespace {

// A large dish is slow to stop, and a fast mount goes far meanwhile. A mount that does both has no brakes.
constexpr Seconds kLongStop{3.0};
constexpr Angle kFarStop = Angle::fromDegrees(10.0);
// Full speed within five ticks: nothing on a mast is driven so hard.
constexpr Seconds kShortRamp{0.1};
// kg·m²: a Yagi of two metres and three kilograms. What turns lighter things is a rotator for a desk.
constexpr double kLightAntenna = 2.0;

QString decimalText(double value, int decimals)
{
    return toQString(formatFixed(value, decimals));
}

// From full speed with the profile's own ramp. The averaging that bounds the jerk takes its time beside it.
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

}  // namespace

std::vector<Advice> adviceOn(const Profile& profile)
{
    std::vector<Advice> list;
    adviseOn(list, "azimuth", Text::tr("the azimuth"), profile.azimuth);
    adviseOn(list, "elevation", Text::tr("the elevation"), profile.elevation);
    adviseOnModel(list, profile);
    return list;
}

}  // namespace boresight::profile
