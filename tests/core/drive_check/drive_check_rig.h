// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive_check/drive_check.h"
#include "core/sim/simulated_pair.h"

#include <deque>

// A drive check on the simulated pair, in hand-turned time. In every tick its frames go on the bus, and it receives
// what arrives until the next tick.
namespace boresight::drive_check {

inline constexpr Seconds kTick{0.02};

class DriveCheckRig
{
public:
    explicit DriveCheckRig(const sim::PairSettings& settings = sim::commissionedPair(),
                           const profile::Profile& profile = {}, const KnownBoards& known = {}, AxisSet axes = kAxes);

    void tick();
    void run(Seconds time);
    // Calls begin() and ticks until the check has ended, Done or not.
    void driveCheck();
    // Ticks until this state. Returns false if it is not reached within the time.
    [[nodiscard]] bool reaches(DriveCheckState state, Seconds within = Seconds(10.0));

    [[nodiscard]] SteadyTime now() const;
    [[nodiscard]] Seconds elapsed() const { return m_elapsed; }
    void otherToolSays(Axis axis, const std::string& command);

    sim::SimulatedPair pair;
    profile::Profile profile;
    profile::InForce inForce{profile};
    DriveCheck drives;
    std::size_t mostFramesForOneDrive = 0;  // in one tick, apart from scans
    std::vector<CanFrame> sent;

private:
    void deliver();

    Seconds m_elapsed{0.0};
    std::deque<sim::PairReply> m_underWay;
};

// Boards with factory settings, but each with its own id.
[[nodiscard]] sim::PairSettings freshFromTheBox();

// The reason why nothing may move. Empty if motion is allowed.
[[nodiscard]] std::string obstacle(const DriveCheck& driveCheck);
// The cause ids of the findings, for matchers.
[[nodiscard]] std::vector<std::string> causes(const DriveCheck& driveCheck);
[[nodiscard]] ProtectionLine line(const DriveCheck& driveCheck, Axis axis, const char* key);

}  // namespace boresight::drive_check
