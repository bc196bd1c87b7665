// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/clock.h"

#include <sys/timex.h>

#include <cmath>
#include <ctime>

namespace boresight {
namespace {

timex askKernel(int& state)
{
    timex query{};  // no mode is set: the call only reads
    state = ::adjtimex(&query);
    return query;
}

std::chrono::nanoseconds timeOf(clockid_t clock)
{
    timespec time{};
    return ::clock_gettime(clock, &time) == 0
               ? std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec)
               : std::chrono::nanoseconds(0);
}

}  // namespace

SteadyTime SystemClock::now() const
{
    return SteadyTime(timeOf(CLOCK_BOOTTIME));
}

UtcTime SystemClock::utc() const
{
    return std::chrono::system_clock::now();
}

bool SystemClock::synchronised() const
{
    int state = 0;
    const timex answer = askKernel(state);
    return isSynchronised(state, answer.status);
}

std::optional<Seconds> SystemClock::error() const
{
    int state = 0;
    const timex answer = askKernel(state);
    return isSynchronised(state, answer.status)
               ? std::optional(reportedError(answer.offset, answer.esterror, answer.status))
               : std::nullopt;
}

// CLOCK_MONOTONIC stops while the computer sleeps.
Seconds SystemClock::slept() const
{
    return timeOf(CLOCK_BOOTTIME) - timeOf(CLOCK_MONOTONIC);
}

bool isSynchronised(int state, int status)
{
    return state >= 0 && state != TIME_ERROR && (status & STA_UNSYNC) == 0;
}

Seconds reportedError(long offset, long estimated, int status)
{
    const Seconds unit = (status & STA_NANO) != 0 ? std::chrono::nanoseconds(1) : std::chrono::microseconds(1);
    return std::abs(offset) * unit + estimated * Seconds(std::chrono::microseconds(1));
}

}  // namespace boresight
