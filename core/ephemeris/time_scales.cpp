// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ephemeris/time_scales.h"

#include <erfa.h>
#include <erfam.h>

namespace boresight::ephemeris {
namespace {

constexpr double kUnixEpoch = 2440587.5;  // Julian date of 1970-01-01 0h

}  // namespace

TwoPartDate universalDate(UtcTime utc)
{
    const auto day = std::chrono::floor<std::chrono::days>(utc);
    return {kUnixEpoch + static_cast<double>(day.time_since_epoch().count()), Seconds(utc - day).count() / ERFA_DAYSEC};
}

TwoPartDate terrestrialTime(UtcTime utc)
{
    const TwoPartDate universal = universalDate(utc);
    TwoPartDate atomic;
    TwoPartDate terrestrial;
    (void)eraUtctai(universal.day, universal.fraction, &atomic.day, &atomic.fraction);
    (void)eraTaitt(atomic.day, atomic.fraction, &terrestrial.day, &terrestrial.fraction);
    return terrestrial;
}

Seconds leapSeconds(std::chrono::sys_days day)
{
    const std::chrono::year_month_day date = day;
    double ahead = 0.0;
    (void)eraDat(static_cast<int>(date.year()), static_cast<int>(static_cast<unsigned>(date.month())),
                 static_cast<int>(static_cast<unsigned>(date.day())), 0.0, &ahead);
    return Seconds(ahead);
}

}  // namespace boresight::ephemeris
