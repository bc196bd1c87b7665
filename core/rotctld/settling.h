// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/sleep_watch.h"

#include <optional>

// The time in which a command that arrives without its own time stamp may be old: it may have waited while the computer
// slept, or while this program was stopped or its thread was blocked. Motions are refused meanwhile. Station thread.
namespace boresight::rotctld {

class Settling
{
public:
    static constexpr std::chrono::seconds kTime{2};

    // The clock outlives this.
    explicit Settling(const Clock& clock) : m_clock(clock), m_sleep(clock), m_lastTurn(clock.now()) {}

    void begin() { m_begin = m_clock.now(); }
    // Call once per tick and before each command. It begins again after any sleep of the computer, and if nobody called
    // it for kTime.
    void tick()
    {
        const SteadyTime now = m_clock.now();
        if (m_sleep.sleptSince(m_clock) > Seconds(0.0) || now - m_lastTurn >= kTime) {
            begin();
        }
        m_lastTurn = now;
    }
    [[nodiscard]] bool isOver() const { return !m_begin || m_clock.now() - *m_begin >= kTime; }

private:
    const Clock& m_clock;
    SleepWatch m_sleep;
    SteadyTime m_lastTurn;
    std::optional<SteadyTime> m_begin;
};

}  // namespace boresight::rotctld
