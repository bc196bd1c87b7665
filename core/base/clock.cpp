// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/clock.h"

#include <sys/timex.h>

namespace boresight {

SteadyTime SystemClock::now() const
{
    return std::chrono::steady_clock::now();
}

UtcTime SystemClock::utc() const
{
    return std::chrono::system_clock::now();
}

bool SystemClock::synchronised() const
{
    timex query{};  // no mode is set: the kernel is asked, nothing is changed
    const int state = ::adjtimex(&query);
    return isSynchronised(state, query.status);
}

bool isSynchronised(int state, int status)
{
    return state >= 0 && state != TIME_ERROR && (status & STA_UNSYNC) == 0;
}

}  // namespace boresight
