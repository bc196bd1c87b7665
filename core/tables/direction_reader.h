// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tables/table.h"
#include "core/tables/table_problem.h"

#include <chrono>
#include <string_view>

// Reads a tracking table. Each line has a time, an azimuth and an elevation, separated by commas, semicolons, tabs or
// blanks. The time is UTC in the forms of core/elements/written_time.h. Further columns, blank lines, lines that begin
// with #, and one header line above all rows are ignored. Pure.
namespace boresight::tables {

// A longer step is a gap, in which nothing is interpolated.
inline constexpr std::chrono::hours kLongestStep{1};

[[nodiscard]] TableReading<DirectionRows> readDirections(std::string_view text);

// The parts of the table without a gap.
[[nodiscard]] std::vector<TableSpan> spansOf(const DirectionRows& rows);

}  // namespace boresight::tables
