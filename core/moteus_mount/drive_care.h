// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/alarms/event_log.h"
#include "core/base/can_frame.h"
#include "core/drive_check/axis_gains.h"
#include "core/drive_check/drive_check.h"
#include "core/messages/permissions.h"
#include "core/messages/request.h"
#include "core/moteus_mount/board_desk.h"
#include "core/moteus_mount/moteus_mount.h"
#include "core/moteus_mount/watched_boards.h"
#include "core/profile/in_force.h"

#include <vector>

// Looks after the drives beside the control of motion. Runs the drive check when drives appear or return, and reports
// to MoteusMount whether they are fit and which boards they are. Raises the alarms about the findings. Writes the
// safety settings when the operator asks for it. Shares the bus with the motion frames. Station thread only.
namespace boresight {

class DriveCare
{
public:
    DriveCare(const profile::InForce& profile, MoteusMount& mount, AlarmBoard& alarms, EventLog& log);

    void take(const CanFrame& frame);
    void profileChanged(const profile::Profile& before, const profile::Profile& after)
    {
        m_driveCheck.profileChanged(before, after);
    }
    // After the tick of the control. Returns the frames to send beside those of the mount.
    [[nodiscard]] std::vector<CanFrame> tick(SteadyTime now);
    // The drive check is done, and nothing here uses the console of a board now.
    [[nodiscard]] bool areConsolesFree() const;
    // While settings are being written, other work on the drives is refused.
    [[nodiscard]] Result<> admits(const Request& request) const;
    // Carries out a request that the control has admitted. Requests that do not concern the drives are ignored.
    [[nodiscard]] Result<> carryOut(const Request& request, SteadyTime now);

    // Fills in its part of the status.
    void fill(DrivesStatus& drives) const;
    // Adds the reasons why requests about the drives would be refused.
    void judge(Permissions& may) const;

private:
    [[nodiscard]] Result<> mayTouch() const;  // nothing is being written
    [[nodiscard]] Result<> mayRead() const;
    [[nodiscard]] Result<> mayFix() const;
    [[nodiscard]] Result<> mayStoreAll() const;  // no gains are on trial: storing would store those too
    [[nodiscard]] Result<> mayChangeBoard() const;
    [[nodiscard]] Result<> mayUse(Axis axis) const;   // the gains of this axis are known
    [[nodiscard]] Result<> mayTune(Axis axis) const;  // the console of the drive is free
    [[nodiscard]] Result<> mayWrite(Axis axis, Gain gain, double value) const;
    [[nodiscard]] Result<> mayPutBack(Axis axis) const;
    [[nodiscard]] Result<> mayStore(Axis axis) const;
    void judgeGains(Permissions& may) const;
    void tendGains(SteadyTime now, std::vector<CanFrame>& frames);
    void watchConnection(SteadyTime now);
    void watchSilence(SteadyTime now);
    [[nodiscard]] std::vector<CanFrame> changeBoard(SteadyTime now);
    void tellMount();
    void tellFindings();
    void tellChanges();
    void fill(Axis axis, DriveStatus& drive) const;

    MoteusMount& m_mount;
    AlarmBoard& m_alarms;
    EventLog& m_log;
    drive_check::DriveCheck m_driveCheck;
    BoardDesk m_boards;
    WatchedBoards m_watched;
    std::array<drive_check::AxisGains, 2> m_gains;
    std::array<int, 2> m_rebootsTold{};
    std::array<bool, 2> m_answering{};
    std::optional<SteadyTime> m_silentSince;  // silence of all drives, while we use the bus
    std::vector<AlarmKey> m_findingsTold;
};

}  // namespace boresight
