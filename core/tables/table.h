// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orbit/vector.h"
#include "core/tables/atomic_time.h"
#include "core/units/sky.h"

#include <QString>

#include <cstddef>
#include <memory>
#include <variant>
#include <vector>

// The content of a file that describes a path through the sky: directions of one site, or positions around the Earth.
// The values never change, so threads share them. table_path.h computes the directions at a site.
namespace boresight::tables {

// The limit for both kinds. A day at 20 Hz has fewer rows.
inline constexpr std::size_t kMostRows = 2'000'000;

struct DirectionRow
{
    AtomicTime time{};
    SkyPointing direction;  // azimuth [0°, 360°), elevation [-90°, 90°]

    bool operator==(const DirectionRow&) const = default;
};

// In the order of time. Consecutive rows are less than 90° apart.
using DirectionRows = std::vector<DirectionRow>;

enum class OrbitFrame
{
    Earth,      // turns with the Earth: ITRF and similar frames
    Celestial,  // GCRF, ICRF, EME2000
    Teme,       // of date, as in SGP4
    OfDate      // TOD: true equator and equinox of date
};

struct OrbitRow
{
    AtomicTime time{};
    orbit::Vector position;  // km
    orbit::Vector velocity;  // km/s, in the same frame

    bool operator==(const OrbitRow&) const = default;
};

// Nothing is interpolated between two segments, because there may be a manoeuvre between them.
struct OrbitSegment
{
    OrbitFrame frame = OrbitFrame::Earth;
    bool usesVelocities = true;  // true: Hermite interpolation; false: Lagrange
    std::size_t nodes = 2;       // number of rows of a polynomial, at most rows.size()
    AtomicTime from{};           // usable range, inside the rows
    AtomicTime to{};
    std::vector<OrbitRow> rows;  // two or more, in the order of time

    bool operator==(const OrbitSegment&) const = default;
};

// In the order of time. A segment ends before the next begins, or at the same time.
using OrbitSegments = std::vector<OrbitSegment>;

// A span of time without a gap.
struct TableSpan
{
    AtomicTime from{};
    AtomicTime to{};

    bool operator==(const TableSpan&) const = default;
};

struct Table
{
    QString name;  // of the object or of the file
    std::variant<DirectionRows, OrbitSegments> rows;
    std::vector<TableSpan> spans;  // one or more, in the order of time

    bool operator==(const Table&) const = default;
};

using SharedTable = std::shared_ptr<const Table>;

// A table of directions is already for one site.
[[nodiscard]] inline bool needsSite(const Table& table)
{
    return std::holds_alternative<OrbitSegments>(table.rows);
}

}  // namespace boresight::tables
