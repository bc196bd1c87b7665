// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/control/arming.h"
#include "core/messages/request.h"
#include "core/messages/station_status.h"
#include "core/mount/mount_driver.h"
#include "core/mount/third_axis.h"
#include "core/profile/in_force.h"
#include "core/tracking/axis_setpoints.h"

#include <optional>

// The jog of the axis beside the two, such as the polarisation. It moves only while the operator holds a button, within
// the limits of the profile, and only while the mount may be moved. Then the axis is held. After the end of a jog for
// any other reason than the button, a new press is needed. Without such an axis it does nothing. Station thread only.
// Mechanical angles.
namespace boresight {

class ThirdAxisJog
{
public:
    struct Parts
    {
        const profile::InForce& profile;
        MountDriver& mount;
        const Arming& arming;
        EventLog& log;
    };

    // The parts outlive this.
    explicit ThirdAxisJog(const Parts& parts) : m_of(parts) {}

    Result<> ask(const request::JogThirdAxis& wanted, const Source& by);
    // Once per tick, after STOP and the faults of this tick are known. `dt`: since the last tick.
    void step(Seconds dt, SteadyTime now);
    // Clears a fault of its drive. False if it has none.
    bool recover(const Source& by);

    [[nodiscard]] bool atRest() const;
    void leave(profile::OnExit how);
    // Its part of the status, and what the operator may do.
    void describe(StationStatus& status) const;

private:
    [[nodiscard]] const tracking::MotionLimits& limits() const { return m_of.profile->thirdAxis.axis.limits; }
    [[nodiscard]] const TravelRange& travel() const { return m_of.profile->thirdAxis.axis.geometry.travel; }
    [[nodiscard]] Result<> mayMove() const;
    [[nodiscard]] Result<> mayJog(AngularRate rate) const;
    void begin(AngularRate rate, const Source& by);
    void watch(ThirdAxis& axis);
    void end(const QString& why);

    Parts m_of;
    AngularRate m_rate;           // of the button; zero: no button is held
    SteadyTime m_deadline{};      // the next keep-alive must arrive before it, while a button is held
    bool m_needsRelease = false;  // a jog was refused or ended, and its button was not released since
    std::optional<tracking::AxisSetpoints> m_motion;  // while the axis follows set-points
    SteadyTime m_now{};
};

}  // namespace boresight
