// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/kept_clock.h"

#include <optional>

// UTC without jumps, for tracking. The operating system corrects the clock all the time, and a satellite can move 1°
// across the sky in a second. Each call takes up at most kMost of a correction. A clock that was set, by more than
// kSet, is taken up at once. Pure.
namespace boresight::sources {

class SteeredUtc
{
public:
    static constexpr std::chrono::milliseconds kSet = KeptClock::kSet;
    static constexpr std::chrono::milliseconds kMost{1};

    // Call once in each tick.
    [[nodiscard]] UtcTime now(const Clock& clock);
    // By how much the clock was set, as seen by the last call. 0 s if it was not set.
    [[nodiscard]] Seconds jump() const { return m_jump; }

private:
    std::optional<UtcTime::duration> m_offset;  // UTC minus steady time
    Seconds m_jump{0.0};
};

}  // namespace boresight::sources
