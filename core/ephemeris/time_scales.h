// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <chrono>

// UTC and the time scales without leap seconds, by the table of ERFA, which ends with 2016-12-31. Like ERFA, it is
// uncertain for dates far in the future. Pure, any thread.
namespace boresight::ephemeris {

// A Julian date in two parts, because one double alone resolves only 40 µs.
struct TwoPartDate
{
    double day = 0.0;
    double fraction = 0.0;
};

[[nodiscard]] TwoPartDate universalDate(UtcTime utc);
[[nodiscard]] TwoPartDate terrestrialTime(UtcTime utc);

// How far atomic time (TAI) is ahead of UTC at the beginning of a day. 0 before 1960, when there was no UTC.
[[nodiscard]] Seconds leapSeconds(std::chrono::sys_days day);

}  // namespace boresight::ephemeris
