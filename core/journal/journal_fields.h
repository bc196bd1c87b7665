// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/journal/mount_journal.h"
#include "core/records/field_list.h"

#include <array>
#include <numbers>
#include <string_view>

// Every key of a mount's journal file, described once (core/records/field_list.h). JOURNAL.md shows the file.
namespace boresight::journal::record {

using records::Range;

// The permitted ranges are wide: they reject broken values, not unusual ones.
inline constexpr double kRadiansPerTurn = 2.0 * std::numbers::pi;
inline constexpr double kCountEnd = 32768.0;  // turns; the count of a moteus wraps there
inline constexpr Range kOfAngle{-1000.0 * kRadiansPerTurn, 1000.0 * kRadiansPerTurn};
inline constexpr Range kOfRate{-100.0 * kRadiansPerTurn, 100.0 * kRadiansPerTurn};  // per second
inline constexpr Range kOfCount{-kCountEnd, kCountEnd};
inline constexpr Range kOfCounted{-(kCountEnd + 2.0) * kRadiansPerTurn, (kCountEnd + 2.0) * kRadiansPerTurn};
inline constexpr Range kOfBeginning{0.0, 16777215.0};  // three bytes
inline constexpr Range kOfOffset{-2.0 * kCountEnd, 2.0 * kCountEnd};
inline constexpr Range kOfUptime{0.0, 4294967.296};  // s: a moteus counts 2^32 ms
inline constexpr Range kOfHomeState{0.0, 2.0};
inline constexpr Range kOfSinceBoot{0.0, 1e10};            // s
inline constexpr Range kOfStopTime{0.0, 3600.0 * 1000.0};  // ms

inline constexpr std::string_view kOriginBeginning = "origin_beginning";
inline constexpr std::string_view kOriginOffset = "origin_offset_turns";
inline constexpr std::string_view kPlaceUsed = "entered_place_used";
inline constexpr std::array<std::string_view, 2> kAxisKeys = {"azimuth", "elevation"};

template <class Visitor>
void turnFields(Visitor& visitor, TurnRecord& record)
{
    visitor.uuid("drive", record.drive);
    inRadians(visitor, "angle_rad", record.angle, kOfAngle);
    inTurns(visitor, "reported_turns", record.reported, kOfCount);
    inRadians(visitor, "counted_rad", record.counted, kOfCounted);
    inSeconds(visitor, "uptime_s", record.uptime, kOfUptime);
    asWhole(visitor, "home_state", record.homeState, kOfHomeState);
    visitor.time("when", record.when);
    visitor.uuidOrEmpty("host_boot", record.host.boot);
    inSeconds(visitor, "host_since_boot_s", record.host.sinceBoot, kOfSinceBoot);
    visitor.flag("host_utc_is_exact", record.host.utcIsExact);
    visitor.flag("moving", record.moving);
    // Both keys are absent if the drive did not report them.
    if (isThere(visitor, {kOriginBeginning, kOriginOffset}, record.origin)) {
        asWhole(visitor, kOriginBeginning, record.origin->beginning, kOfBeginning);
        inTurns(visitor, kOriginOffset, record.origin->offset, kOfOffset);
    }
}

template <class Visitor>
void crashStopFields(Visitor& visitor, CrashStop& stop)
{
    visitor.uuid("drive", stop.drive);
    inRadians(visitor, "rate_rad_s", stop.rate, kOfRate);
    inRadians(visitor, "angle_rad", stop.angle, kOfAngle);
    inMilliseconds(visitor, "time_ms", stop.time, kOfStopTime);
    visitor.time("when", stop.when);
}

// A missing axis or stop is valid: the axis was never recorded, or its stop was never tested.
template <class Visitor>
void journalFields(Visitor& visitor, MountJournal& journal)
{
    for (std::size_t i = 0; i < kAxisKeys.size(); ++i) {
        visitor.table(kAxisKeys[i], journal, [i](Visitor& axis, MountJournal& both) {
            optionalTable(axis, "turn", both.turns[i], turnFields<Visitor>);
            optionalTable(axis, "crash_stop", both.crashStops[i], crashStopFields<Visitor>);
        });
    }
    if (isThere(visitor, {kPlaceUsed}, journal.placeUsed)) {
        visitor.time(kPlaceUsed, *journal.placeUsed);
    }
}

}  // namespace boresight::journal::record
