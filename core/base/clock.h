// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <optional>

// The clock is injected, so that tests can set the time by hand. Ages and control use steady time, orbits and logs use
// UTC. Steady time continues while the computer sleeps. Any thread may read a SystemClock.
namespace boresight {

using Seconds = std::chrono::duration<double>;
using SteadyTime = std::chrono::steady_clock::time_point;
using UtcTime = std::chrono::system_clock::time_point;

class Clock
{
public:
    virtual ~Clock() = default;
    [[nodiscard]] virtual SteadyTime now() const = 0;
    [[nodiscard]] virtual UtcTime utc() const = 0;
    // True if NTP, PTP or a GPS receiver keeps this computer's clock synchronised to UTC.
    [[nodiscard]] virtual bool synchronised() const = 0;
    // The error of the UTC, as the time source reports it. Empty: it is not reported.
    [[nodiscard]] virtual std::optional<Seconds> error() const = 0;
    // How long this computer has slept since its start.
    [[nodiscard]] virtual Seconds slept() const = 0;
    // How far the clock of this computer is set ahead of utc(). Always 0 s, except for a KeptClock.
    [[nodiscard]] virtual Seconds ahead() const { return Seconds(0.0); }
    // The clock of this computer as it is set. Other programs write this time into their files and messages.
    [[nodiscard]] UtcTime computerUtc() const { return utc() + std::chrono::duration_cast<UtcTime::duration>(ahead()); }

protected:
    Clock() = default;
    Clock(const Clock&) = default;
    Clock& operator=(const Clock&) = default;
};

class SystemClock final : public Clock
{
public:
    [[nodiscard]] SteadyTime now() const override;
    [[nodiscard]] UtcTime utc() const override;
    [[nodiscard]] bool synchronised() const override;
    [[nodiscard]] std::optional<Seconds> error() const override;
    [[nodiscard]] Seconds slept() const override;
};

// Arguments: the return value and the status bits of adjtimex(2).
[[nodiscard]] bool isSynchronised(int state, int status);
// The sum of the pending correction and the estimated error (µs) of adjtimex(2). The correction is in ns or µs,
// depending on the status.
[[nodiscard]] Seconds reportedError(long offset, long estimated, int status);

}  // namespace boresight
