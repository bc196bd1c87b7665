// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/quantity.h"
#include "core/units/sky.h"

#include <optional>

// The last stall of this computer: how long it sent no commands, and where the axes were commanded to be. Decides
// whether the motion may continue after the watchdogs of the drives stopped it. With several stalls in a row, the
// set-points of the one that stopped the drives count, and none continues a motion that an earlier one has ended. Pure,
// one thread. Mechanical angles.
namespace boresight {

class OwnStall
{
public:
    // The time `gap` passed between two ticks or two sendings. A drive stops by itself when it gets no command for the
    // time `watchdog`. True if the drive may have stopped.
    bool note(Seconds gap, Seconds watchdog, const AxisPosition& setpoints, SteadyTime now);

    // The computer slept before `now`, and this was not seen before. Nobody expects a motion after a sleep.
    void woke(SteadyTime now) { m_woke = now; }

    // The link has accepted the frames of a tick. A tick that is held up after its beginning sends them late, too. True
    // as above.
    bool sent(Seconds watchdog, const AxisPosition& setpoints, SteadyTime now);

    // A time-out that is seen now comes from the stall, and the stall was short enough to continue.
    [[nodiscard]] bool explainsTimeOut(SteadyTime now) const;
    // How long the stall lasted that ended a moment ago. Empty if there was none.
    [[nodiscard]] std::optional<Seconds> recent(SteadyTime now) const;
    // The axis is where a mount that braked from its set-point can be.
    [[nodiscard]] bool isNear(Axis axis, Angle measured) const;

    // The drives are being captured again.
    void resume(SteadyTime now);
    void end() { m_resuming = false; }
    [[nodiscard]] bool resuming() const { return m_resuming; }
    // The drives had enough time to come back, even if this computer stalls again.
    [[nodiscard]] bool isLate(SteadyTime now) const;
    [[nodiscard]] Seconds gap() const { return m_gap; }

private:
    Seconds m_gap{0.0};
    SteadyTime m_end{};
    std::optional<SteadyTime> m_sent;
    AxisPosition m_setpoints{};
    std::optional<SteadyTime> m_woke;
    bool m_possible = true;  // after this stall the motion may continue
    bool m_resuming = false;
    SteadyTime m_resumingSince{};
};

}  // namespace boresight
