// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/quantity.h"
#include "core/units/sky.h"

#include <optional>

// The last stall of this computer: for how long it sent no commands, and where the axes were to be. Decides whether the
// motion may go on after the drives stopped by their watchdogs. Of stalls in a row, the one that stopped them tells
// where they stand. Pure, one thread; mechanical angles.
namespace boresight {

class OwnStall
{
public:
    // Between two ticks or two sendings passed `gap`. A drive stops by itself when it gets no command for `watchdog`.
    // True if it may have.
    bool note(Seconds gap, Seconds watchdog, const AxisPosition& setpoints, SteadyTime now);

    // The link has the frames of a tick. A tick that was held up after its beginning sends late, too. True as above.
    bool sent(Seconds watchdog, const AxisPosition& setpoints, SteadyTime now);

    // A time-out that is seen now comes from the stall, and the stall was short enough to go on.
    [[nodiscard]] bool explainsTimeOut(SteadyTime now) const;
    // How long the stall was that ended a moment ago; empty: there was none, or one that is not worth a word.
    [[nodiscard]] std::optional<Seconds> recent(SteadyTime now) const;
    // The axis stands where a braked mount can stand.
    [[nodiscard]] bool isNear(Axis axis, Angle measured) const;

    // The drives are being taken over again.
    void resume(SteadyTime now);
    void end() { m_resuming = false; }
    [[nodiscard]] bool resuming() const { return m_resuming; }
    // The drives had their time, also if this computer goes on stalling.
    [[nodiscard]] bool isLate(SteadyTime now) const;
    [[nodiscard]] Seconds gap() const { return m_gap; }

private:
    Seconds m_gap{0.0};
    SteadyTime m_end{};
    std::optional<SteadyTime> m_sent;
    AxisPosition m_setpoints{};
    bool m_possible = false;  // that a watchdog acted, and that the motion may go on
    bool m_resuming = false;
    SteadyTime m_resumingSince{};
};

}  // namespace boresight
