// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/sky_time.h"

#include "core/base/numbers.h"
#include "core/elements/element_check.h"
#include "core/elements/iso_epoch.h"

#include <QDateTime>

#include <chrono>
#include <cmath>
#include <optional>

namespace boresight::ctl {
namespace {

// A plain number below is not meant as Unix seconds: that would be the year of 1973.
constexpr double kFirstUnixSeconds = 1e8;
constexpr double kLastUnixSeconds = 7.2e9;  // 2198
constexpr int kMicrosecondDigits = 6;

std::optional<UtcTime> unixTime(std::string_view text)
{
    const auto seconds = parseFinite(text);
    if (!seconds || *seconds < kFirstUnixSeconds || *seconds > kLastUnixSeconds) {
        return std::nullopt;
    }
    return UtcTime(std::chrono::round<std::chrono::microseconds>(Seconds(*seconds)));
}

// What parseIsoEpoch() wants is whole: the time of a day alone, and seconds, are added.
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

Result<UtcTime> parseSkyTime(std::string_view text)
{
    const auto date = orbit::parseIsoEpoch(completed(text));
    const auto utc = date ? std::optional(orbit::utcTime(*date)) : unixTime(text);
    if (!utc) {
        return failure(ErrorCode::InvalidInput,
                       QStringLiteral("\"%1\" is no time: expected UTC like 2024-05-10T04:50:02Z, or Unix seconds")
                           .arg(orbit::quoted(text)));
    }
    return *utc;
}

std::string skyTimeText(UtcTime utc, int digits)
{
    const auto rounded = std::chrono::round<std::chrono::microseconds>(utc.time_since_epoch());
    const auto second = std::chrono::floor<std::chrono::seconds>(rounded);
    const std::string whole = QDateTime::fromSecsSinceEpoch(second.count(), Qt::UTC)
                                  .toString(QStringLiteral("yyyy-MM-ddTHH:mm:ss"))
                                  .toStdString();
    std::string fraction = std::to_string((rounded - second).count());
    fraction.insert(0, static_cast<std::size_t>(kMicrosecondDigits) - fraction.size(), '0');
    const std::size_t needed = fraction.find_last_not_of('0') + 1;  // 0 of a whole second
    fraction.resize(std::max(needed, static_cast<std::size_t>(digits)));
    return whole + (fraction.empty() ? "" : ".") + fraction + "Z";
}

}  // namespace boresight::ctl
