// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/motion_source.h"

// Parks a mount that holds, after the time of the profile without a motion and without a command of anybody. What is
// tracked is not idle, nor is a mount that nobody has moved since the start, a fault or STOP. It takes the control from
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

    SteadyTime m_since{};   // idle; of no meaning while it is not
    bool m_isDone = false;  // parked, or refused once
};

}  // namespace boresight::sources
