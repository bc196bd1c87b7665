// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

// The clock of a rehearsal. It begins at a given UTC, and its owner advances it. One thread.
namespace boresight {

class TurnedClock final : public Clock
{
public:
    explicit TurnedClock(UtcTime utc) : m_utc(utc) {}

    [[nodiscard]] SteadyTime now() const override { return m_now; }
    [[nodiscard]] UtcTime utc() const override { return m_utc; }
    [[nodiscard]] bool synchronised() const override { return true; }
    [[nodiscard]] std::optional<Seconds> error() const override { return std::nullopt; }
    [[nodiscard]] Seconds slept() const override { return Seconds(0.0); }

    void advance(std::chrono::nanoseconds time)
    {
        m_now += time;
        skip(time);
    }
    // Skips a time in which nothing happens. Only the UTC advances.
    void skip(std::chrono::nanoseconds time) { m_utc += std::chrono::duration_cast<UtcTime::duration>(time); }

private:
    SteadyTime m_now{std::chrono::hours(1)};
    UtcTime m_utc;
};

}  // namespace boresight
