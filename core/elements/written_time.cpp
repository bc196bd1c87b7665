// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/written_time.h"

#include "core/base/clock.h"
#include "core/base/numbers.h"
#include "core/elements/iso_epoch.h"

#include <chrono>
#include <string>

namespace boresight::orbit {

namespace {

// A smaller plain number is not read as Unix seconds: they would be before 1973.
constexpr double kFirstUnixSeconds = 1e8;
constexpr double kLastUnixSeconds = 7.2e9;  // 2198

std::optional<JulianDate> unixTime(std::string_view text)
{
    const auto seconds = parseFinite(text);
    if (!seconds || *seconds < kFirstUnixSeconds || *seconds > kLastUnixSeconds) {
        return std::nullopt;
    }
    return julianDate(UtcTime(std::chrono::round<std::chrono::microseconds>(Seconds(*seconds))));
}

// Completes the text for parseIsoEpoch(): adds the time to a date alone, and missing seconds.
std::string completed(std::string_view text)
{
    constexpr std::size_t kHoursAndMinutes = 5;
    constexpr std::string_view kNoOffset = "+00:00";
    std::string whole(text.ends_with(kNoOffset) ? text.substr(0, text.size() - kNoOffset.size())
                                                : text.substr(0, text.size() - (text.ends_with('Z') ? 1 : 0)));
    const std::size_t split = whole.find_first_of("T ");
    if (split == std::string::npos) {
        return whole + "T00:00:00";
    }
    return whole.size() - split - 1 == kHoursAndMinutes ? whole + ":00" : whole;
}

}  // namespace

std::optional<JulianDate> parseWrittenTime(std::string_view text)
{
    const auto date = parseIsoEpoch(completed(text));
    return date ? date : unixTime(text);
}

}  // namespace boresight::orbit
