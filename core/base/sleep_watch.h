// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

// Notices that the computer slept between two calls. One thread.
namespace boresight {

class SleepWatch
{
public:
    // A shorter difference is no sleep: the two clocks of the kernel are read one after the other.
    static constexpr Seconds kShortest{0.1};

    explicit SleepWatch(const Clock& clock) : m_slept(clock.slept()) {}

    // How long the computer slept since the last sleep that was noticed. 0 s if it did not sleep.
    [[nodiscard]] Seconds sleptSince(const Clock& clock)
    {
        const Seconds slept = clock.slept() - m_slept;
        if (slept <= kShortest) {
            return Seconds(0.0);
        }
        m_slept += slept;
        return slept;
    }

private:
    Seconds m_slept;
};

}  // namespace boresight
