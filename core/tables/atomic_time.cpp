// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/atomic_time.h"

#include "core/ephemeris/time_scales.h"

#include <cmath>

namespace boresight::tables {
namespace {

using std::chrono::nanoseconds;

constexpr double kUnixEpochDay = 2440587.5;  // Julian date of 1970-01-01 0h
constexpr double kMicrosecondsPerDay = 86400e6;
constexpr std::chrono::seconds kGpsBehind{19};
constexpr std::chrono::milliseconds kTerrestrialAhead{32'184};

nanoseconds leap(std::chrono::sys_days day)
{
    return std::chrono::round<nanoseconds>(ephemeris::leapSeconds(day));
}

}  // namespace

std::optional<TimeSystem> timeSystem(std::string_view name)
{
    return name == "UTC"                   ? std::optional(TimeSystem::Utc)
           : name == "TAI"                 ? std::optional(TimeSystem::Tai)
           : name == "GPS"                 ? std::optional(TimeSystem::Gps)
           : name == "TT" || name == "TDT" ? std::optional(TimeSystem::Tt)
                                           : std::optional<TimeSystem>();
}

AtomicTime atomicTime(const orbit::JulianDate& written, TimeSystem system)
{
    const std::chrono::days days(std::llround(written.day - kUnixEpochDay));
    const nanoseconds shown = days + std::chrono::microseconds(std::llround(written.fraction * kMicrosecondsPerDay));
    switch (system) {
        case TimeSystem::Utc:
            return shown + leap(std::chrono::sys_days(days));
        case TimeSystem::Gps:
            return shown + kGpsBehind;
        case TimeSystem::Tt:
            return shown - kTerrestrialAhead;
        case TimeSystem::Tai:
            break;
    }
    return shown;
}

AtomicTime atomicTime(UtcTime utc)
{
    return utc.time_since_epoch() + leap(std::chrono::floor<std::chrono::days>(utc));
}

// The day by TAI may be one day late, so the first step may be wrong by a second.
UtcTime utcTime(AtomicTime time)
{
    const UtcTime atomic(std::chrono::duration_cast<UtcTime::duration>(time));
    const UtcTime nearly = atomic - leap(std::chrono::floor<std::chrono::days>(atomic));
    return atomic - leap(std::chrono::floor<std::chrono::days>(nearly));
}

}  // namespace boresight::tables
