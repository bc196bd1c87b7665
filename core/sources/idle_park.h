// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/motion_source.h"

// Parks a mount that holds, after the time in the profile without a motion and without a command. The mount is not idle
// while it tracks a target, or if nobody has moved it since the start, a fault or STOP. Parking takes control from
// nobody. Station thread only.
namespace boresight::sources {

class IdlePark : public SourceOf<IdlePark>
{
public:
    using SourceOf::SourceOf;

    void step(SteadyTime now) override;

private:
    [[nodiscard]] bool isIdle() const;
    void park();

    SteadyTime m_since{};   // start of the idle time, or of the last tick that was not idle
    bool m_isDone = false;  // parking was started or refused in this idle time
};

}  // namespace boresight::sources
