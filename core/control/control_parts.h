// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/base/clock.h"
#include "core/control/antenna_choice.h"
#include "core/control/arming.h"
#include "core/control/client_control.h"
#include "core/control/current_motion.h"
#include "core/control/energy_meter.h"
#include "core/control/slew_watch.h"
#include "core/guards/brake_guard.h"
#include "core/guards/cable_guard.h"
#include "core/guards/end_switch_guard.h"
#include "core/guards/standstill_watch.h"
#include "core/guards/sun_watch.h"
#include "core/guards/wind_guard.h"
#include "core/motion/first_moves.h"
#include "core/motion/motion.h"
#include "core/mount/mount_driver.h"
#include "core/pointing/mount_model.h"
#include "core/profile/profile.h"

#include <cstdint>

// The parts of StationControl for classes that only read them: its gates and its reports. Station thread only.
namespace boresight {

struct ControlParts
{
    const profile::Profile& profile;
    const Clock& clock;
    const pointing::MountModel& model;
    const AntennaChoice& antenna;
    const MountDriver& mount;
    const Motion& motion;
    const StandstillWatch& standstill;
    const CurrentMotion& current;
    const Arming& arming;
    const ClientControl& clientControl;
    const CableGuard& cable;
    const SunWatch& sun;
    const SlewWatch& slew;
    const EnergyMeter& energy;
    const WindGuard& wind;
    const BrakeGuard& brake;
    const EndSwitchGuard& endSwitches;
    const AlarmBoard& alarms;
    SteadyTime now;    // of the running or last tick
    SteadyTime asked;  // when the last request came, accepted or refused
    std::uint64_t tick = 0;

    // Where the set-points are. If Boresight moves no axis: where the axes are.
    [[nodiscard]] AxisPosition standing() const
    {
        return mount.follows() ? motion.place() : mount.measured().value_or(AxisPosition{});
    }
    // Where the axes would stop if they braked now.
    [[nodiscard]] AxisPosition stoppingPlace() const
    {
        const auto rest = [this](Axis axis) { return restingPlace(motion.setpoint(axis), motion.limits(axis)); };
        return mount.follows() ? AxisPosition{.azimuth = rest(Axis::Azimuth), .elevation = rest(Axis::Elevation)}
                               : standing();
    }
    // Where the axes are going. If they go nowhere: where they stand.
    [[nodiscard]] AxisPosition heading() const
    {
        return mount.follows() ? motion.target(now).value_or(motion.place()) : standing();
    }
};

}  // namespace boresight
