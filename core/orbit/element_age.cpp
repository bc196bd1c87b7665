// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orbit/element_age.h"

#include "core/elements/julian_date.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace boresight::orbit {

namespace {

constexpr double kSecondsPerDay = 86'400.0;
constexpr double kGravity = 398'600.8;  // km³/s², WGS-72
// The usual error of public sets at their epoch. On low orbits it grows by 1 to 3 km a day.
constexpr double kAtEpoch = 1.0;  // km
constexpr double kEachDay = 1.5;  // km
// The real drag differs from that of the set by this part, because the Sun heats the air.
constexpr double kPartOfDrag = 0.2;

}  // namespace

AgeError expectedError(const ElementSet& elements, UtcTime at)
{
    const double days = std::abs(Seconds(at - utcTime(elements.epoch)).count()) / kSecondsPerDay;
    const double period = kSecondsPerDay / elements.revolutionsPerDay;
    const double motion = 2.0 * std::numbers::pi / period;
    const double radius = std::cbrt(kGravity / (motion * motion));
    const double around = 2.0 * std::numbers::pi * radius;
    const double byDrag = kPartOfDrag * std::abs(elements.meanMotionDot) * days * days * around;
    // The error cannot exceed half an orbit.
    const double kilometres = std::min(kAtEpoch + kEachDay * days + byDrag, around / 2.0);
    return {.kilometres = kilometres, .time = Seconds(kilometres / around * period)};
}

}  // namespace boresight::orbit
