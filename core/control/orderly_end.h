// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/profile/profile.h"

// The end of the program: the mount slows down, the drives get their last order for a moment, then it is done. Pure,
// one thread.
namespace boresight {

class OrderlyEnd
{
public:
    // True the first time.
    [[nodiscard]] bool begin(const profile::Profile& profile, SteadyTime now);
    // Once in a tick. True once when the drives are to be left: the mount is still, or took too long.
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
