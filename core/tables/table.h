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

// What a file says of a way through the sky: directions of one site, or places around the Earth. Values that nobody
// changes, so threads share them. Where it leads over a site: table_path.h.
namespace boresight::tables {

// Of both kinds together. A day at 20 Hz has fewer.
inline constexpr std::size_t kMostRows = 2'000'000;

struct DirectionRow
{
    AtomicTime time{};
    SkyPointing direction;  // azimuth [0°, 360°), elevation [-90°, 90°]

    bool operator==(const DirectionRow&) const = default;
};

// In the order of time. Rows that follow one another are less than 90° apart.
using DirectionRows = std::vector<DirectionRow>;

enum class OrbitFrame
{
    Earth,      // turns with the Earth: ITRF and its kin
    Celestial,  // GCRF, ICRF, EME2000
    Teme,       // of the date, as SGP4 has it
    OfDate      // TOD: true equator and equinox of the date
};

struct OrbitRow
{
    AtomicTime time{};
    orbit::Vector position;  // km
    orbit::Vector velocity;  // km/s, in the same frame

    bool operator==(const OrbitRow&) const = default;
};

// Nothing is interpolated from one segment to the next: there was a manoeuvre, or nobody knows.
struct OrbitSegment
{
    OrbitFrame frame = OrbitFrame::Earth;
    bool usesVelocities = true;  // Hermite's polynomials, else those of Lagrange
    std::size_t nodes = 2;       // rows of a polynomial, at most rows.size()
    AtomicTime from{};           // usable, inside the rows
    AtomicTime to{};
    std::vector<OrbitRow> rows;  // two or more, in the order of time

    bool operator==(const OrbitSegment&) const = default;
};

// In the order of time. One ends before the next begins, or as it begins.
using OrbitSegments = std::vector<OrbitSegment>;

// Without a gap.
struct TableSpan
{
    AtomicTime from{};
    AtomicTime to{};

    bool operator==(const TableSpan&) const = default;
};

struct Table
{
    QString name;  // of the object, or of the file
    std::variant<DirectionRows, OrbitSegments> rows;
    std::vector<TableSpan> spans;  // one or more, in the order of time

    bool operator==(const Table&) const = default;
};

using SharedTable = std::shared_ptr<const Table>;

// Directions are those of one site already.
[[nodiscard]] inline bool needsSite(const Table& table)
{
    return std::holds_alternative<OrbitSegments>(table.rows);
}

}  // namespace boresight::tables
