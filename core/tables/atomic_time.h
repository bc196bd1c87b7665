// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/elements/julian_date.h"

#include <chrono>
#include <optional>
#include <string_view>

// Tables use time without leap seconds, so that the time between two rows does not jump. Pure.
namespace boresight::tables {

// TAI since midnight TAI of 1970-01-01.
using AtomicTime = std::chrono::nanoseconds;

enum class TimeSystem
{
    Utc,
    Tai,
    Gps,  // 19 s behind TAI
    Tt    // 32.184 s ahead of TAI
};

// The time system of "UTC", "TAI", "GPS", "TT" or its older name "TDT".
[[nodiscard]] std::optional<TimeSystem> timeSystem(std::string_view name);

// To the microsecond. A fraction of 1 or more is inside a leap second.
[[nodiscard]] AtomicTime atomicTime(const orbit::JulianDate& written, TimeSystem system);
[[nodiscard]] AtomicTime atomicTime(UtcTime utc);
// A time in a leap second becomes the second after it, because UtcTime has no leap seconds.
[[nodiscard]] UtcTime utcTime(AtomicTime time);

}  // namespace boresight::tables
