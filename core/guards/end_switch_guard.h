// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/contacts/input_name.h"
#include "core/end_switches/end_switch.h"
#include "core/end_switches/switch_watch.h"
#include "core/messages/end_switch_status.h"
#include "core/motion/motion.h"
#include "core/mount/mount_driver.h"
#include "core/profile/in_force.h"

#include <QString>

#include <array>
#include <optional>
#include <vector>

// Decides which ends of the axes their switches have closed, and raises the alarms about the switches. Motion keeps the
// set-points from moving into a closed end, whatever the source of the motion. A switch that is met at another angle
// than its own shows that the axis has lost steps. The station reads the inputs. Without
// end switches in the profile nothing is closed. Station thread only.
namespace boresight {

class EndSwitchGuard
{
public:
    using Readings = std::array<contacts::InputReading, end_switches::kEndSwitches.size()>;

    struct Parts
    {
        const profile::InForce& profile;
        const MountDriver& mount;
        const Motion& motion;
        AlarmBoard& alarms;
    };
    // The mount ran into a closed end.
    struct Hit
    {
        Axis axis = Axis::Azimuth;
        QString why;
    };

    // An input that was not read yet is no alarm for this time.
    static constexpr std::chrono::seconds kPatience{5};

    // The parts outlive the guard.
    explicit EndSwitchGuard(const Parts& parts) : m_of(parts) {}

    // What the inputs read, by end_switches::indexOf(), before each tick.
    void take(const Readings& readings) { m_readings = readings; }
    // Once in a tick, before the sources. `isFault`: a fault of the mount is latched. `isReachable`: the mount can be
    // asked now. Returns an end that the mount runs into, once until the fault is re-armed.
    [[nodiscard]] std::optional<Hit> step(bool isFault, bool isReachable, SteadyTime now);

    // The mount has made a home run, so its axes are counted from their switches again.
    void homed() { m_losses = {}; }

    // The ends of this axis that are closed. All set-points respect them.
    [[nodiscard]] ClosedEnds closed(Axis axis) const;
    // An axis that runs into a closed end has to stop as soon as it can.
    [[nodiscard]] bool isUrgent() const;
    // Whether the axis may move this way. The error names the switch.
    [[nodiscard]] Result<> admits(Axis axis, bool upwards) const;
    [[nodiscard]] Result<> admits(const AxisRates& rates) const;
    [[nodiscard]] Result<> admitsWay(const AxisPosition& from, const AxisPosition& to) const;

    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    // Of the switches that the profile names.
    [[nodiscard]] std::vector<EndSwitchStatus> status() const;

private:
    [[nodiscard]] bool isUsed(const end_switches::EndSwitch& one) const;
    [[nodiscard]] bool isClosed(const end_switches::EndSwitch& one) const;
    [[nodiscard]] std::optional<bool> isPressed(const end_switches::EndSwitch& one) const;
    [[nodiscard]] QString whyLost(const end_switches::EndSwitch& one) const;
    void judgePlace(const end_switches::EndSwitch& one);
    [[nodiscard]] QString whyClosed(const end_switches::EndSwitch& one) const;
    [[nodiscard]] QString problemOf(const end_switches::EndSwitch& one) const;
    void tell(const end_switches::EndSwitch& one, bool isReachable, SteadyTime now);
    void clearAlarms();

    Parts m_of;
    Readings m_readings;
    std::array<end_switches::SwitchWatch, end_switches::kEndSwitches.size()> m_watches;
    // The state of a closed switch when the mount ran into its end. Empty after the re-arm.
    std::array<std::optional<end_switches::SwitchState>, end_switches::kEndSwitches.size()> m_hitIn{};
    // An axis met its switch at another angle than that of the switch. Lasts until a home run, or until the axis meets
    // it where it is.
    struct Loss
    {
        Angle shown;
        Angle known;
    };
    std::array<std::optional<Loss>, end_switches::kEndSwitches.size()> m_losses{};
    std::optional<SteadyTime> m_since;  // of the first step with these settings
};

}  // namespace boresight
