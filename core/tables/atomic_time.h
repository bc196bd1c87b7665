// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/elements/julian_date.h"

#include <chrono>
#include <optional>
#include <string_view>

// The time between two rows of a table does not jump, so tables are kept in time without leap seconds. Pure.
namespace boresight::tables {

// TAI since its midnight of 1970-01-01.
using AtomicTime = std::chrono::nanoseconds;

enum class TimeSystem
{
    Utc,
    Tai,
    Gps,  // 19 s behind TAI
    Tt    // 32.184 s ahead of TAI
};

// "UTC", "TAI", "GPS", "TT" or its older name "TDT".
[[nodiscard]] std::optional<TimeSystem> timeSystem(std::string_view name);

// To the microsecond. A fraction of 1 and more is a leap second.
[[nodiscard]] AtomicTime atomicTime(const orbit::JulianDate& written, TimeSystem system);
[[nodiscard]] AtomicTime atomicTime(UtcTime utc);
// A leap second is the second after it, because UtcTime has none.
[[nodiscard]] UtcTime utcTime(AtomicTime time);

}  // namespace boresight::tables
