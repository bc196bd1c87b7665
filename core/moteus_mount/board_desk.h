// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/messages/drives_status.h"
#include "core/messages/permissions.h"
#include "core/messages/request.h"
#include "core/profile/in_force.h"
#include "core/survey/board_change.h"
#include "core/survey/drive_survey.h"

#include <string>
#include <vector>

// What the operator decides about single boards: which axis the only connected board belongs to, and its gear. Both are
// normal for boards from the factory: all have one id and count turns of the motor. Takes the bus from the drive check
// meanwhile. Station thread only.
namespace boresight {

class BoardDesk
{
public:
    BoardDesk(const profile::InForce& profile, const survey::DriveSurvey& survey, AxisSet axes, EventLog& log)
        : m_profile(profile), m_survey(survey), m_axes(axes), m_log(log)
    {}

    [[nodiscard]] Result<> admits(const request::AssignBoard& wanted) const;
    [[nodiscard]] Result<> admits(const request::SetGear& wanted) const;
    void begin(const request::AssignBoard& wanted, SteadyTime now);
    void begin(const request::SetGear& wanted, SteadyTime now);

    [[nodiscard]] bool isRunning() const { return m_change.isRunning(); }
    // The axis whose gear is being written: its drive changes its count in the middle of that.
    [[nodiscard]] const std::optional<Axis>& geared() const { return m_geared; }
    // The axis, once, after a gear was written: the drive counts from a new zero, with other gains.
    [[nodiscard]] std::optional<Axis> takeGeared() { return std::exchange(m_ended, std::nullopt); }
    // The operator goes on: what came of the last work is no longer told.
    void forgetOutcome() { m_change.forgetOutcome(); }
    // The frames of this tick. True in `ended` when the work is over with it.
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
    const survey::DriveSurvey& m_survey;
    AxisSet m_axes;
    EventLog& m_log;
    survey::BoardChange m_change;
    QString m_done;                // what to say when it has worked
    bool m_isGear = false;         // the last work was on a gear
    std::optional<Axis> m_geared;  // its gear is being written
    std::optional<Axis> m_ended;   // and that has ended
};

}  // namespace boresight
