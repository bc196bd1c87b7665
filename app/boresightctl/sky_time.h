// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"

#include <string>
#include <string_view>

// Times of the command line and of tables. Pure.
namespace boresight::ctl {

// "2024-05-10T04:50:02.5Z": with Z, +00:00 or neither, with or without fraction and seconds, with a blank for the T,
// the day of the year for month and day, the day alone for its midnight, or Unix seconds. UTC, of the years 1957 to
// 2199.
[[nodiscard]] Result<UtcTime> parseSkyTime(std::string_view text);

// "2024-05-10T04:50:02Z". `digits` of a second at least, and more, up to six, if it takes them to write the time.
[[nodiscard]] std::string skyTimeText(UtcTime utc, int digits);

}  // namespace boresight::ctl
