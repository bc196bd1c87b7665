// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/ephemeris/earth_axis.h"
#include "core/orbit/topocentric.h"
#include "core/tables/table.h"

#include <optional>

// The directions of a table at a site, airless like the table. The object keeps the orientation of the Earth's axis for
// ten minutes, so it belongs to one thread.
namespace boresight::tables {

struct TablePlace
{
    SkyPointing direction;             // azimuth [0°, 360°)
    std::optional<double> kilometres;  // empty: the table has directions only

    bool operator==(const TablePlace&) const = default;
};

// A time above the horizon without a gap. at() succeeds at both ends.
struct TableStay
{
    UtcTime from;
    std::optional<UtcTime> to;  // empty: it lasts beyond the end of the search

    bool operator==(const TableStay&) const = default;
};

class TablePath
{
public:
    // `table` must not be null. `observer` is ignored if the table needs no site.
    TablePath(SharedTable table, const orbit::Observer& observer);

    // NotAvailable, with the reason, if the table has nothing at this time. Nothing is extrapolated or interpolated
    // over a gap.
    [[nodiscard]] Result<TablePlace> at(UtcTime utc);
    // The stay that contains `from`, or the next one that begins before `until`. Refused with the reason if there is
    // none.
    [[nodiscard]] Result<TableStay> nextStay(UtcTime from, UtcTime until);

private:
    using Span = std::vector<TableSpan>::const_iterator;
    struct Look
    {
        AtomicTime before;  // nothing changes before this time
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
