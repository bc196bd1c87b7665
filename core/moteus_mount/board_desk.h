// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/drive_check/board_change.h"
#include "core/drive_check/drive_check.h"
#include "core/messages/drives_status.h"
#include "core/messages/permissions.h"
#include "core/messages/request.h"
#include "core/profile/in_force.h"

#include <string>
#include <vector>

// The work on single boards that the operator starts: assigning the only connected board to an axis, and writing its
// gear. Both are needed for boards from the factory, which all have the same id and count turns of the motor. While the
// work runs, this class has the bus in place of the drive check. Station thread only.
namespace boresight {

class BoardDesk
{
public:
    BoardDesk(const profile::InForce& profile, const drive_check::DriveCheck& driveCheck, AxisSet axes, EventLog& log)
        : m_profile(profile), m_driveCheck(driveCheck), m_axes(axes), m_log(log)
    {}

    [[nodiscard]] Result<> admits(const request::AssignBoard& wanted) const;
    [[nodiscard]] Result<> admits(const request::SetGear& wanted) const;
    void begin(const request::AssignBoard& wanted, SteadyTime now);
    void begin(const request::SetGear& wanted, SteadyTime now);

    [[nodiscard]] bool isRunning() const { return m_change.isRunning(); }
    // The axis whose gear is being written. The position count of its drive changes during the work.
    [[nodiscard]] const std::optional<Axis>& geared() const { return m_geared; }
    // The axis, once, after its gear was written. The drive then counts from a new zero and has other gains.
    [[nodiscard]] std::optional<Axis> takeGeared() { return std::exchange(m_ended, std::nullopt); }
    // The operator continues, so the result of the last work is not shown any more.
    void forgetOutcome() { m_change.forgetOutcome(); }
    // The frames of this tick. Sets `ended` when the work ends with this tick.
    [[nodiscard]] std::vector<CanFrame> frames(SteadyTime now, bool& ended);
    void take(const CanFrame& frame);

    void fill(DrivesStatus& drives) const;
    void judge(Permissions& may) const;

private:
    [[nodiscard]] Result<> mayAssign(Axis axis) const;
    [[nodiscard]] Result<> maySetGear(Axis axis) const;
    [[nodiscard]] bool hasDrive(Axis axis) const;
    [[nodiscard]] std::optional<GearCorrection> gear(Axis axis) const;
    void finish();

    const profile::InForce& m_profile;
    const drive_check::DriveCheck& m_driveCheck;
    AxisSet m_axes;
    EventLog& m_log;
    drive_check::BoardChange m_change;
    QString m_done;                // the message after success
    bool m_isGear = false;         // the last work wrote a gear
    std::optional<Axis> m_geared;  // the axis whose gear is being written
    std::optional<Axis> m_ended;   // the axis whose gear was written, until it is taken
};

}  // namespace boresight
