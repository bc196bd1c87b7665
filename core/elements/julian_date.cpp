// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/julian_date.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace boresight::orbit {

namespace {

constexpr double kUnixEpochDay = 2440587.5;  // Julian date of 1970-01-01 0h
constexpr double kMicrosecondsPerDay = 86400e6;
constexpr double kDaysOfUtcTime = 106751.0;  // on each side of 1970: the range of 64 bits of nanoseconds

}  // namespace

JulianDate julianDate(UtcTime utc)
{
    const auto day = std::chrono::floor<std::chrono::days>(utc);
    const std::chrono::duration<double, std::chrono::days::period> since = utc - day;
    return {kUnixEpochDay + static_cast<double>(day.time_since_epoch().count()), since.count()};
}

UtcTime utcTime(const JulianDate& date)
{
    const double days = std::clamp(date.day - kUnixEpochDay, -kDaysOfUtcTime, kDaysOfUtcTime);
    const double rest = std::clamp(date.fraction, 0.0, 1.0);
    const std::chrono::microseconds within(std::llround(rest * kMicrosecondsPerDay));
    const std::chrono::microseconds before(std::llround(days) * std::llround(kMicrosecondsPerDay));
    return UtcTime(std::chrono::duration_cast<UtcTime::duration>(before + within));
}

JulianDate julianDate(int year, double days)
{
    const std::chrono::sys_days newYear = std::chrono::year(year) / std::chrono::January / 1;
    const double whole = std::floor(days);
    return {kUnixEpochDay + static_cast<double>(newYear.time_since_epoch().count()) + whole, days - whole};
}

}  // namespace boresight::orbit
