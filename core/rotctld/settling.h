// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <optional>

// The time in which a command that arrives without its own time stamp may be old: it may have waited while the computer
// slept, or while nobody read. Motions are refused meanwhile. Station thread.
namespace boresight::rotctld {

class Settling
{
public:
    static constexpr std::chrono::seconds kTime{2};

    // The clock outlives this.
    explicit Settling(const Clock& clock) : m_clock(clock), m_slept(clock.slept()) {}

    void begin() { m_begin = m_clock.now(); }
    // Begins it after the computer slept for kTime. Each tick, and before each command.
    void tick()
    {
        if (m_clock.slept() - m_slept >= kTime) {
            m_slept = m_clock.slept();
            begin();
        }
    }
    [[nodiscard]] bool isOver() const { return !m_begin || m_clock.now() - *m_begin >= kTime; }

private:
    const Clock& m_clock;
    Seconds m_slept;  // by the computer, at the last beginning
    std::optional<SteadyTime> m_begin;
};

}  // namespace boresight::rotctld
