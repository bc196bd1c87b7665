// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orbit/sidereal_time.h"

#include <cmath>
#include <numbers>

namespace boresight::orbit {

namespace {

constexpr double kStandardEpochDay = 2451545.0;  // Julian date of 2000-01-01 12h
constexpr double kDaysPerCentury = 36525.0;

}  // namespace

double siderealTime(const JulianDate& date)
{
    const double centuries = ((date.day - kStandardEpochDay) + date.fraction) / kDaysPerCentury;
    const double seconds =
        67310.54841 + centuries * ((876600.0 * 3600.0 + 8640184.812866) + centuries * (0.093104 - centuries * 6.2e-6));
    const double turns = seconds / 86400.0;
    return (turns - std::floor(turns)) * 2.0 * std::numbers::pi;
}

}  // namespace boresight::orbit
