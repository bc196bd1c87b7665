// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/iso_epoch.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <chrono>

namespace boresight::orbit {

namespace {

// A number of exactly `length` digits.
std::optional<int> digitsAt(std::string_view text, std::size_t from, std::size_t length)
{
    if (text.size() < from + length) {
        return std::nullopt;
    }
    const std::string_view part = text.substr(from, length);
    const auto value =
        part.find_first_not_of("0123456789") == std::string_view::npos ? parseInteger(part) : std::nullopt;
    return value ? std::optional(static_cast<int>(*value)) : std::nullopt;
}

// Days since 1 January, from "2024-05-09" or "2024-130".
std::optional<int> dayOfYear(std::string_view date, std::chrono::year year)
{
    constexpr std::size_t kByMonth = 10;
    constexpr std::size_t kByDay = 8;
    const std::chrono::sys_days newYear = year / std::chrono::January / 1;
    if (date.size() == kByDay) {
        const auto day = digitsAt(date, 5, 3);
        return day && *day >= 1 && *day <= (year.is_leap() ? 366 : 365) ? std::optional(*day - 1) : std::nullopt;
    }
    const auto month = digitsAt(date, 5, 2);
    const auto day = digitsAt(date, 8, 2);
    if (date.size() != kByMonth || date[7] != '-' || !month || !day) {
        return std::nullopt;
    }
    const std::chrono::year_month_day whole =
        year / std::chrono::month(static_cast<unsigned>(*month)) / std::chrono::day(static_cast<unsigned>(*day));
    return whole.ok() ? std::optional(static_cast<int>((std::chrono::sys_days(whole) - newYear).count()))
                      : std::nullopt;
}

// Parses for example "08:48:19.938816". A leap second is second 60.
std::optional<double> partOfDay(std::string_view time)
{
    constexpr std::size_t kSeconds = 6;
    constexpr double kSecondsOfLeapMinute = 61.0;
    const auto hours = digitsAt(time, 0, 2);
    const auto minutes = digitsAt(time, 3, 2);
    if (!hours || !minutes || time.size() < kSeconds + 2 || time[2] != ':' || time[5] != ':') {
        return std::nullopt;
    }
    const std::string_view text = time.substr(kSeconds);
    const bool isPlain = text.find_first_not_of(".0123456789") == std::string_view::npos;
    const double seconds = (isPlain ? parseFinite(text) : std::nullopt).value_or(kSecondsOfLeapMinute);
    if (*hours > 23 || *minutes > 59 || seconds >= kSecondsOfLeapMinute) {
        return std::nullopt;
    }
    return (*hours * 3600.0 + *minutes * 60.0 + seconds) / 86400.0;
}

}  // namespace

std::optional<JulianDate> parseIsoEpoch(std::string_view text)
{
    if (text.ends_with('Z')) {
        text.remove_suffix(1);
    }
    const std::size_t split = std::min(text.find_first_of("T "), text.size());
    const auto year = digitsAt(text, 0, 4);
    if (split == text.size() || !year || *year < 1957 || *year > 2199 || text[4] != '-') {
        return std::nullopt;
    }
    const auto day = dayOfYear(text.substr(0, split), std::chrono::year(*year));
    const auto part = partOfDay(text.substr(split + 1));
    if (!day || !part) {
        return std::nullopt;
    }
    JulianDate date = julianDate(*year, *day);
    date.fraction = *part;
    return date;
}

}  // namespace boresight::orbit
