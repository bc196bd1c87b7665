// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

// A UTC time as a Julian date in two parts, because one double alone resolves only 40 µs. Pure value, any thread.
namespace boresight::orbit {

struct JulianDate
{
    double day = 0.0;       // ends with .5: midnight
    double fraction = 0.0;  // of the day, [0, 1)

    bool operator==(const JulianDate&) const = default;
};

inline constexpr double kMinutesPerDay = 1440.0;

[[nodiscard]] JulianDate julianDate(UtcTime utc);
// Rounded to the microsecond. Dates outside the range of UtcTime (1678 to 2262) become its first or last day.
[[nodiscard]] UtcTime utcTime(const JulianDate& date);
// `days` after the first midnight of a year of the Gregorian calendar. May be negative or longer than the year.
[[nodiscard]] JulianDate julianDate(int year, double days);

// Leap seconds inside the span are not counted. This is the convention of element sets.
[[nodiscard]] inline double minutesBetween(const JulianDate& from, const JulianDate& to)
{
    return (to.day - from.day) * kMinutesPerDay + (to.fraction - from.fraction) * kMinutesPerDay;
}

}  // namespace boresight::orbit
