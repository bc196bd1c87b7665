// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <atomic>

// A clock that is turned by hand. Both times advance together, unless the test sets the UTC. The clock counts as
// synchronised until the test changes that. Any thread may read it.
namespace boresight::fakes {

class ManualClock final : public Clock
{
public:
    ManualClock() = default;
    // For rigs that are returned by value.
    ManualClock(const ManualClock& other)
        : m_now(other.now()),
          m_utc(other.utc()),
          m_synchronised(other.synchronised()),
          m_error(other.m_error.load()),
          m_slept(other.slept()),
          m_ahead(other.ahead())
    {}

    [[nodiscard]] SteadyTime now() const override { return m_now; }
    [[nodiscard]] UtcTime utc() const override { return m_utc; }
    [[nodiscard]] bool synchronised() const override { return m_synchronised; }
    [[nodiscard]] std::optional<Seconds> error() const override
    {
        return m_synchronised ? std::optional(m_error.load()) : std::nullopt;
    }
    [[nodiscard]] Seconds slept() const override { return m_slept.load(); }
    [[nodiscard]] Seconds ahead() const override { return m_ahead.load(); }
    void advance(Seconds time)
    {
        m_now = m_now.load() + std::chrono::duration_cast<SteadyTime::duration>(time);
        stepUtc(time);
    }
    void stepUtc(Seconds by) { m_utc = m_utc.load() + std::chrono::duration_cast<UtcTime::duration>(by); }
    void setUtc(UtcTime utc) { m_utc = utc; }
    void setSynchronised(bool synchronised) { m_synchronised = synchronised; }
    // As the time source reports it while the clock is synchronised.
    void setError(Seconds error) { m_error = error; }
    // As if this were a KeptClock, and the clock of the computer were set by this time.
    void setAhead(Seconds ahead) { m_ahead = ahead; }
    // The computer was suspended for this time.
    void sleep(Seconds time)
    {
        m_slept = m_slept.load() + time;
        advance(time);
    }

private:
    std::atomic<SteadyTime> m_now{SteadyTime(std::chrono::hours(1))};
    std::atomic<UtcTime> m_utc{std::chrono::sys_days{std::chrono::year{2026} / 11 / 21}};
    std::atomic<bool> m_synchronised = true;
    std::atomic<Seconds> m_error = Seconds(0.001);
    std::atomic<Seconds> m_slept = Seconds(0.0);
    std::atomic<Seconds> m_ahead = Seconds(0.0);
};

}  // namespace boresight::fakes
