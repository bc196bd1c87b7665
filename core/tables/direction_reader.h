// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tables/table.h"
#include "core/tables/table_problem.h"

#include <chrono>
#include <string_view>

// A tracking table: in each line a time, an azimuth and an elevation, with commas, semicolons, tabs or blanks between.
// The time is UTC in the forms of core/elements/written_time.h. Further columns, blank lines, lines that begin with #,
// and one line of names above all rows are left out. Pure.
namespace boresight::tables {

// Over a longer step nothing is interpolated: there the table has a gap.
inline constexpr std::chrono::hours kLongestStep{1};

[[nodiscard]] TableReading<DirectionRows> readDirections(std::string_view text);

// The stretches without a gap.
[[nodiscard]] std::vector<TableSpan> spansOf(const DirectionRows& rows);

}  // namespace boresight::tables
