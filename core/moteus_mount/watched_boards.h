// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/messages/drives_status.h"
#include "core/moteus_mount/drive.h"
#include "core/profile/further_boards.h"
#include "core/profile/in_force.h"

#include <string>
#include <vector>

// The boards on the bus that the profile names and that turn no axis. They are only queried, and never commanded. A
// fault or a silence of such a board is an alarm. Pure: time is passed in.
namespace boresight {

class WatchedBoards
{
public:
    // Profile and alarms outlive this.
    WatchedBoards(const profile::InForce& profile, AlarmBoard& alarms) : m_profile(profile), m_alarms(alarms) {}

    void take(const CanFrame& frame);
    // The queries of this tick.
    [[nodiscard]] std::vector<CanFrame> frames(SteadyTime now);
    // The bus is released to other tools, which may do anything to the boards.
    void rest();
    [[nodiscard]] std::vector<WatchedDrive> status() const;  // as of the last tick

private:
    struct Board
    {
        profile::WatchedBoard named;
        Drive drive;  // always Listening
    };

    void followProfile(SteadyTime now);
    void judge(const Board& board, SteadyTime now);

    const profile::InForce& m_profile;
    AlarmBoard& m_alarms;
    std::vector<std::string> m_named;  // as in the profile, when the boards were made
    std::vector<Board> m_boards;
    SteadyTime m_now{};
    SteadyTime m_since{};  // when the boards were queried first
    SteadyTime m_nextQuestion{};
};

}  // namespace boresight
