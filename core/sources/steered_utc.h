// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <optional>

// UTC for a motion that goes on: the clock of the computer is corrected all the time, and a satellite goes 1° across
// the sky in a second. A small correction is taken up by no more than 1 ms in each call, a set clock at once. Pure.
namespace boresight::sources {

class SteeredUtc
{
public:
    // What is more is no correction: somebody has set the clock.
    static constexpr std::chrono::milliseconds kSet{500};
    static constexpr std::chrono::milliseconds kMost{1};

    // Once in a tick.
    [[nodiscard]] UtcTime now(const Clock& clock);
    // By how much the clock was set with the last call; zero: it was not.
    [[nodiscard]] Seconds jump() const { return m_jump; }

private:
    std::optional<UtcTime::duration> m_offset;  // of UTC from steady time
    Seconds m_jump{0.0};
};

}  // namespace boresight::sources
