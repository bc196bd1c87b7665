// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orbit/vector.h"
#include "core/tables/table.h"

#include <span>

// The polynomial through some rows: by Hermite, who goes by the velocities too, or by Lagrange. Pure.
namespace boresight::tables {

// Of a polynomial. Files have 5 to 11.
inline constexpr int kMostDegree = 25;

// The rows of a segment that are used for a time inside it: as many before as behind, where there are so many.
[[nodiscard]] std::span<const OrbitRow> rowsAround(const OrbitSegment& segment, AtomicTime at);

// `rows` are two or more in the order of time, and no more than the degree permits. Not finite where they are too
// uneven.
[[nodiscard]] orbit::Vector placeBetween(std::span<const OrbitRow> rows, AtomicTime at, bool usesVelocities);

}  // namespace boresight::tables
