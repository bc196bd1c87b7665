// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/profile/profile.h"

// The end of the program: the mount brakes, then the drives receive their last command for a short time. Pure, one
// thread.
namespace boresight {

class OrderlyEnd
{
public:
    // True for the first call only.
    [[nodiscard]] bool begin(const profile::Profile& profile, SteadyTime now);
    // Once in a tick. True in the one tick in which the drives are to be left: the mount stands still, or braking took
    // too long.
    [[nodiscard]] bool leaves(bool still, SteadyTime now);
    [[nodiscard]] bool done() const { return m_phase == Phase::Done; }

private:
    enum class Phase
    {
        No,
        Slowing,
        Leaving,
        Done
    };

    Phase m_phase = Phase::No;
    SteadyTime m_deadline{};
};

}  // namespace boresight
