// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/ephemeris/earth_axis.h"
#include "core/orbit/topocentric.h"
#include "core/tables/table.h"

#include <optional>

// Where a table leads over a site, airless as the table is. It remembers for ten minutes how the Earth's axis stands,
// so it belongs to one thread.
namespace boresight::tables {

struct TablePlace
{
    SkyPointing direction;             // azimuth [0°, 360°)
    std::optional<double> kilometres;  // empty: the table has directions only

    bool operator==(const TablePlace&) const = default;
};

// Above the horizon, without a gap. Both ends have a place.
struct TableStay
{
    UtcTime from;
    std::optional<UtcTime> to;  // empty: not before the end of the search

    bool operator==(const TableStay&) const = default;
};

class TablePath
{
public:
    // `table` is not null. The observer is without meaning where the table needs no site.
    TablePath(SharedTable table, const orbit::Observer& observer);

    // NotAvailable with the reason: the table has nothing there. It is never extrapolated, nor interpolated over a gap.
    [[nodiscard]] Result<TablePlace> at(UtcTime utc);
    // The stay in which `from` is, or the next one that begins before `until`. Refused with the reason: there is none.
    [[nodiscard]] Result<TableStay> nextStay(UtcTime from, UtcTime until);

private:
    using Span = std::vector<TableSpan>::const_iterator;
    struct Look
    {
        AtomicTime before;  // nothing changes until then
        AtomicTime now;
    };

    [[nodiscard]] Span spanFrom(AtomicTime time) const;
    [[nodiscard]] Result<TablePlace> place(AtomicTime time);
    [[nodiscard]] std::optional<TablePlace> seenFrom(const OrbitSegment& segment, AtomicTime time);
    [[nodiscard]] bool isUp(AtomicTime time);
    [[nodiscard]] Look nextLook(AtomicTime time, bool up, const TableSpan& span) const;
    [[nodiscard]] AtomicTime change(AtomicTime before, AtomicTime after);
    [[nodiscard]] std::optional<TableSpan> stayIn(const TableSpan& span);
    [[nodiscard]] Error nothingAt(AtomicTime time) const;

    SharedTable m_table;
    orbit::Observer m_observer;
    ephemeris::EarthAxis m_axis;
};

}  // namespace boresight::tables
