// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orbit/vector.h"
#include "core/tables/table.h"

#include <span>

// The interpolation polynomial through some rows: Hermite's, which also uses the velocities, or Lagrange's. Pure.
namespace boresight::tables {

// The highest permitted degree of a polynomial. Files have 5 to 11.
inline constexpr int kMostDegree = 25;

// The rows of a segment that are used for a time inside it: equal numbers before and after, where possible.
[[nodiscard]] std::span<const OrbitRow> rowsAround(const OrbitSegment& segment, AtomicTime at);

// `rows` are two or more in the order of time, and no more than the degree permits. The result is not finite if the
// times are too uneven.
[[nodiscard]] orbit::Vector placeBetween(std::span<const OrbitRow> rows, AtomicTime at, bool usesVelocities);

}  // namespace boresight::tables
