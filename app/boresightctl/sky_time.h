// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"

#include <string>
#include <string_view>

// Times of the command line and of tables. Pure.
namespace boresight::ctl {

// For example "2024-05-10T04:50:02.5Z". The zone is Z, +00:00 or missing. Fraction and seconds may be missing. A blank
// may replace the T, and the day of the year may replace month and day. A day alone means its midnight. Unix seconds
// are valid, too. UTC, years 1957 to 2199.
[[nodiscard]] Result<UtcTime> parseSkyTime(std::string_view text);

// For example "2024-05-10T04:50:02Z". Writes at least `digits` decimals of a second, and up to six if the time needs
// them.
[[nodiscard]] std::string skyTimeText(UtcTime utc, int digits);
// Rounded to three decimals of a second, for a cell of a table.
[[nodiscard]] std::string skyTimeCell(UtcTime utc);

}  // namespace boresight::ctl
