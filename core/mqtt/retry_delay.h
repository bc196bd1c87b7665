// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <chrono>

// The delay before the next attempt to reach a broker: 1, 2, 4, 8, 16, then 30 s each time. Pure.
namespace boresight::mqtt {

class RetryDelay
{
public:
    static constexpr std::chrono::seconds kFirst{1};
    static constexpr std::chrono::seconds kLongest{30};

    std::chrono::seconds next()
    {
        const std::chrono::seconds delay = m_next;
        m_next = std::min(2 * m_next, kLongest);
        return delay;
    }
    void reset() { m_next = kFirst; }

private:
    std::chrono::seconds m_next = kFirst;
};

}  // namespace boresight::mqtt
