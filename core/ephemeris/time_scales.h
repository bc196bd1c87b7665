// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <chrono>

// UTC and the times without leap seconds, by the table of ERFA: the last one is that of 2016-12-31. Its doubt about
// dates far ahead is ours as well. Pure, any thread.
namespace boresight::ephemeris {

// A Julian date in two parts: one double alone would resolve only 40 µs.
struct TwoPartDate
{
    double day = 0.0;
    double fraction = 0.0;
};

[[nodiscard]] TwoPartDate universalDate(UtcTime utc);
[[nodiscard]] TwoPartDate terrestrialTime(UtcTime utc);

// By how much atomic time (TAI) is ahead of UTC at the beginning of a day. Before 1960 there was no UTC, and it is 0.
[[nodiscard]] Seconds leapSeconds(std::chrono::sys_days day);

}  // namespace boresight::ephemeris
