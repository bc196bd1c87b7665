// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/table_path.h"

#include "core/base/text.h"
#include "core/base/time_of_day.h"
#include "core/tables/row_polynomial.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <utility>

namespace boresight::tables {
namespace {

// A shorter stay above the horizon may be missed.
constexpr std::chrono::seconds kLookEach{20};
constexpr std::chrono::milliseconds kExact{1};

orbit::Vector unitVector(const SkyPointing& direction)
{
    const double level = std::cos(direction.elevation.radians());
    return {level * std::cos(direction.azimuth.radians()), level * std::sin(direction.azimuth.radians()),
            std::sin(direction.elevation.radians())};
}

SkyPointing directionOf(const orbit::Vector& unit)
{
    return {.azimuth = Angle::fromRadians(std::atan2(unit.y, unit.x)).wrapped360(),
            .elevation = Angle::fromRadians(std::atan2(unit.z, std::hypot(unit.x, unit.y)))};
}

// On the great circle, at a constant rate. The directions are less than 90° apart.
SkyPointing between(const SkyPointing& first, const SkyPointing& second, double part)
{
    const orbit::Vector a = unitVector(first);
    const orbit::Vector b = unitVector(second);
    const double apart = 2.0 * std::asin(std::min(orbit::length(b - a) / 2.0, 1.0));
    constexpr double kSame = 1e-9;  // radians
    return apart < kSame ? first
                         : directionOf((std::sin((1.0 - part) * apart) / std::sin(apart)) * a +
                                       (std::sin(part * apart) / std::sin(apart)) * b);
}

SkyPointing directionIn(const DirectionRows& rows, AtomicTime time)
{
    const auto after = std::ranges::upper_bound(rows, time, {}, &DirectionRow::time);
    const DirectionRow& before = *(after - 1);
    return before.time == time || after == rows.end()
               ? before.direction
               : between(before.direction, after->direction,
                         Seconds(time - before.time).count() / Seconds(after->time - before.time).count());
}

// The last segment that has begun. At a border of two segments it is the later one.
const OrbitSegment& segmentAt(const OrbitSegments& segments, AtomicTime time)
{
    return *(std::ranges::upper_bound(segments, time, {}, &OrbitSegment::from) - 1);
}

ephemeris::EarthAxis::Vector asArray(const orbit::Vector& vector)
{
    return {vector.x, vector.y, vector.z};
}

orbit::Vector asVector(const ephemeris::EarthAxis::Vector& array)
{
    return {array[0], array[1], array[2]};
}

QString timeText(AtomicTime time)
{
    return dayAndTimeText(utcTime(time));
}

}  // namespace

TablePath::TablePath(SharedTable table, const orbit::Observer& observer)
    : m_table(std::move(table)), m_observer(observer)
{}

// The first span that has not ended by this time.
TablePath::Span TablePath::spanFrom(AtomicTime time) const
{
    return std::ranges::lower_bound(m_table->spans, time, {}, &TableSpan::to);
}

Error TablePath::nothingAt(AtomicTime time) const
{
    const auto& spans = m_table->spans;
    const auto next = spanFrom(time);
    const QString reason =
        next == spans.end()     ? Text::tr("The table of %1 ended at %2.").arg(m_table->name, timeText(spans.back().to))
        : next == spans.begin() ? Text::tr("The table of %1 begins at %2.").arg(m_table->name, timeText(next->from))
                                : Text::tr("The table of %1 has a gap from %2 to %3.")
                                      .arg(m_table->name, timeText((next - 1)->to), timeText(next->from));
    return {ErrorCode::NotAvailable, reason};
}

std::optional<TablePlace> TablePath::seenFrom(const OrbitSegment& segment, AtomicTime time)
{
    const UtcTime utc = utcTime(time);
    orbit::Vector place = placeBetween(rowsAround(segment, time), time, segment.usesVelocities);
    switch (segment.frame) {
        case OrbitFrame::Teme:
            place = orbit::groundState({.position = place, .velocity = {}}, orbit::julianDate(utc)).position;
            break;
        case OrbitFrame::Celestial:
            place = asVector(m_axis.ofTheEarth(asArray(place), utc));
            break;
        case OrbitFrame::OfDate:
            place = asVector(m_axis.ofTheEarthFromDate(asArray(place), utc));
            break;
        case OrbitFrame::Earth:
            break;
    }
    const orbit::LookAngles seen = m_observer.look({.position = place, .velocity = {}});
    return std::isfinite(seen.kilometres) && seen.kilometres > 0.0
               ? std::optional(TablePlace{.direction = seen.direction, .kilometres = seen.kilometres})
               : std::nullopt;
}

Result<TablePlace> TablePath::place(AtomicTime time)
{
    const auto span = spanFrom(time);
    if (span == m_table->spans.end() || time < span->from) {
        return tl::unexpected(nothingAt(time));
    }
    if (const auto* const rows = std::get_if<DirectionRows>(&m_table->rows)) {
        return TablePlace{.direction = directionIn(*rows, time), .kilometres = {}};
    }
    const auto seen = seenFrom(segmentAt(std::get<OrbitSegments>(m_table->rows), time), time);
    if (!seen) {
        return failure(ErrorCode::NotAvailable,
                       Text::tr("The rows of %1 at %2 are too uneven to interpolate between them.")
                           .arg(m_table->name, timeText(time)));
    }
    return *seen;
}

Result<TablePlace> TablePath::at(UtcTime utc)
{
    return place(atomicTime(utc));
}

bool TablePath::isUp(AtomicTime time)
{
    const auto seen = place(time);
    return seen && seen->direction.elevation >= Angle{};
}

// Between two directions above the horizon the great circle is above it, too. So for directions it is enough to look at
// each row. The rows are visited in order, because a search for each row of a day would delay the station.
TablePath::Look TablePath::nextLook(AtomicTime time, bool up, const TableSpan& span) const
{
    const auto* const rows = std::get_if<DirectionRows>(&m_table->rows);
    if (!rows) {
        return {.before = time, .now = std::min<AtomicTime>(time + kLookEach, span.to)};
    }
    const auto next = std::ranges::upper_bound(*rows, time, {}, &DirectionRow::time);
    const auto found = std::find_if(next, rows->end(), [&](const DirectionRow& row) {
        return row.time >= span.to || (row.direction.elevation >= Angle{}) != up;
    });
    return {.before = found == next ? time : std::prev(found)->time,
            .now = found == rows->end() ? span.to : std::min(found->time, span.to)};
}

// The rise or set between two times: the first or the last moment above the horizon.
AtomicTime TablePath::change(AtomicTime before, AtomicTime after)
{
    const bool rises = isUp(after);
    while (after - before > kExact) {
        const AtomicTime middle = before + (after - before) / 2;
        (isUp(middle) == rises ? after : before) = middle;
    }
    return rises ? after : before;
}

std::optional<TableSpan> TablePath::stayIn(const TableSpan& span)
{
    AtomicTime last = span.from;
    AtomicTime begins = last;
    bool wasUp = isUp(last);
    while (last < span.to) {
        const Look look = nextLook(last, wasUp, span);
        const bool up = isUp(look.now);
        if (up && !wasUp) {
            begins = change(look.before, look.now);
        }
        if (!up && wasUp) {
            return TableSpan{.from = begins, .to = change(look.before, look.now)};
        }
        wasUp = up;
        last = look.now;
    }
    if (!wasUp) {
        return std::nullopt;
    }
    return TableSpan{.from = begins, .to = span.to};
}

Result<TableStay> TablePath::nextStay(UtcTime from, UtcTime until)
{
    const AtomicTime first = atomicTime(from);
    const AtomicTime last = atomicTime(until);
    auto span = spanFrom(first);
    if (span == m_table->spans.end() || span->from > last) {
        const QString remedy =
            span == m_table->spans.end() ? QLatin1Char(' ') + Text::tr("Use a table with later times.") : QString();
        return failure(ErrorCode::Refused, nothingAt(first).text + remedy);
    }
    for (; span != m_table->spans.end() && span->from <= last; ++span) {
        const TableSpan searched{.from = std::max(span->from, first), .to = std::min(span->to, last)};
        if (const auto stay = stayIn(searched)) {
            const bool goesOn = stay->to == last && stay->to < span->to;
            return TableStay{.from = utcTime(stay->from),
                             .to = goesOn ? std::nullopt : std::optional(utcTime(stay->to))};
        }
    }
    return failure(ErrorCode::Refused, Text::tr("The table of %1 has nothing above the horizon from %2 to %3.")
                                           .arg(m_table->name, dayAndTimeText(from), dayAndTimeText(until)));
}

}  // namespace boresight::tables
