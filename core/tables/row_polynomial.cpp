// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/row_polynomial.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>

namespace boresight::tables {

std::span<const OrbitRow> rowsAround(const OrbitSegment& segment, AtomicTime at)
{
    const auto after = std::ranges::upper_bound(segment.rows, at, {}, &OrbitRow::time) - segment.rows.begin();
    const auto nodes = static_cast<std::ptrdiff_t>(segment.nodes);
    const auto last = static_cast<std::ptrdiff_t>(segment.rows.size()) - nodes;
    const auto first = std::clamp<std::ptrdiff_t>(after - nodes / 2, 0, last);
    return std::span(segment.rows).subspan(static_cast<std::size_t>(first), segment.nodes);
}

// Newton's divided differences. A row with its velocity counts as two rows at the same time. Times are in units of the
// span of the rows, so that their powers stay small.
orbit::Vector placeBetween(std::span<const OrbitRow> rows, AtomicTime at, bool usesVelocities)
{
    const std::size_t each = usesVelocities ? 2 : 1;
    const std::size_t count = rows.size() * each;
    const double seconds = Seconds(rows.back().time - rows.front().time).count();
    const auto counted = [&](AtomicTime time) { return Seconds(time - rows.front().time).count() / seconds; };
    std::array<double, kMostDegree + 2> times{};
    std::array<orbit::Vector, kMostDegree + 2> differences{};
    for (std::size_t i = 0; i < count; ++i) {
        times[i] = counted(rows[i / each].time);
        differences[i] = rows[i / each].position;
    }
    for (std::size_t order = 1; order < count; ++order) {
        for (std::size_t i = count - 1; i >= order; --i) {
            const double width = times[i] - times[i - order];
            differences[i] =
                width > 0.0 ? (1.0 / width) * (differences[i] - differences[i - 1]) : seconds * rows[i / each].velocity;
        }
    }
    const double time = counted(at);
    orbit::Vector place = differences[count - 1];
    for (std::size_t i = count - 1; i > 0; --i) {
        place = differences[i - 1] + (time - times[i - 1]) * place;
    }
    return place;
}

}  // namespace boresight::tables
