// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

// The clock of a rehearsal: it begins at a given UTC, and its owner turns it on. One thread.
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
    // Of what nothing happens in.
    void skip(std::chrono::nanoseconds time) { m_utc += std::chrono::duration_cast<UtcTime::duration>(time); }

private:
    SteadyTime m_now{std::chrono::hours(1)};
    UtcTime m_utc;
};

}  // namespace boresight
