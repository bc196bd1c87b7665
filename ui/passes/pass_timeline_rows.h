// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/satellite_mark.h"
#include "core/messages/schedule_status.h"
#include "ui/passes/pass_table.h"

#include <QString>

#include <cstddef>
#include <cstdint>
#include <vector>

// The listed passes as rows of a timeline, one for each satellite. Favourites come first, then watched satellites, then
// the others, each group in the order of rising. Pure.
namespace boresight::ui {

// The decision of the schedule about a pass.
enum class PassPlan
{
    None,
    Tracked,
    LeftOut  // watched, but another pass is tracked or the limits hide it
};

struct TimelineBar
{
    UtcTime rises{};
    UtcTime highest{};
    UtcTime sets{};
    Angle elevation;  // the highest elevation
    PassPlan plan = PassPlan::None;
    std::vector<passes::Stretch> tracked = {};  // the parts that the schedule tracks; an omitted pass may keep some
};

struct TimelineRow
{
    std::int64_t number = 0;
    QString name;
    bool isFavourite = false;
    std::vector<TimelineBar> bars;
};

struct Timeline
{
    std::vector<TimelineRow> rows;
    std::size_t leftOut = 0;  // number of satellites without a row
};

inline constexpr std::size_t kMostTimelineRows = 40;

[[nodiscard]] Timeline timelineOf(const PassTable& passes, const orbit::SatelliteMarks& marks,
                                  const schedule::NightPlan& plan);

}  // namespace boresight::ui
