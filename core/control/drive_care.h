// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/base/can_frame.h"
#include "core/control/station_control.h"
#include "core/messages/permissions.h"
#include "core/messages/request.h"
#include "core/profile/profile.h"
#include "core/survey/drive_survey.h"

#include <vector>

// Looks after the drives beside the control of motion: surveys them whenever they come (back), tells StationControl
// whether they are fit and who they are, raises the alarms of what was found, and writes their protections when the
// operator asks for it. Shares the bus with the motion frames. Station thread only.
namespace boresight {

class DriveCare
{
public:
    DriveCare(const profile::Profile& profile, StationControl& control, EventLog& log);

    void take(const CanFrame& frame) { m_survey.take(frame); }
    // After the tick of StationControl; the frames to send beside its own.
    void setProfile(const profile::Profile& profile) { m_survey.setProfile(profile); }
    [[nodiscard]] std::vector<CanFrame> tick(SteadyTime now);
    // While settings are being written, nothing else is done to the drives.
    [[nodiscard]] Result<> admits(const Request& request) const;
    // Carries out what StationControl has admitted; other requests are not its business.
    [[nodiscard]] Result<> carryOut(const Request& request, SteadyTime now);

    // Its part of the status.
    void fill(DrivesStatus& drives) const;
    // Adds why it would not admit what the operator may ask of the drives.
    void judge(Permissions& may) const;

private:
    [[nodiscard]] Result<> mayTouch() const;  // nothing is being written
    [[nodiscard]] Result<> mayRead() const;
    [[nodiscard]] Result<> mayFix() const;
    void watchConnection(SteadyTime now);
    void watchSilence(SteadyTime now);
    void tellControl();
    void tellFindings();
    void tellChanges();
    void fill(Axis axis, DriveStatus& drive) const;

    StationControl& m_control;
    EventLog& m_log;
    survey::DriveSurvey m_survey;
    std::array<int, 2> m_rebootsTold{};
    std::array<bool, 2> m_answering{};
    std::optional<SteadyTime> m_silentSince;  // of both drives, on a bus that is ours
    std::vector<QString> m_findingsTold;      // their causes
};

}  // namespace boresight
