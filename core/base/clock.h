// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <optional>

// Time is injected, so that tests turn it by hand. Ages and control use steady time, orbits and logs use UTC.
// Any thread may read a SystemClock.
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
    // A time source vouches for the UTC: NTP, PTP or a GPS receiver disciplines this computer's clock.
    [[nodiscard]] virtual bool synchronised() const = 0;
    // How far the UTC is off, as the time source reports it. Empty: nobody reports it.
    [[nodiscard]] virtual std::optional<Seconds> error() const = 0;
    // How long this computer has slept since its start. The steady time stands still meanwhile.
    [[nodiscard]] virtual Seconds slept() const = 0;

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

// What adjtimex(2) returned, and the status bits that it gave.
[[nodiscard]] bool isSynchronised(int state, int status);
// The correction that is still to come and the estimated error (µs) of adjtimex(2), added up. The first is in ns or µs,
// as the status says.
[[nodiscard]] Seconds reportedError(long offset, long estimated, int status);

}  // namespace boresight
