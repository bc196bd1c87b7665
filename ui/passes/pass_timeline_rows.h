// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/satellite_mark.h"
#include "core/messages/schedule_status.h"
#include "ui/passes/pass_table.h"

#include <QString>

#include <cstddef>
#include <cstdint>
#include <vector>

// The listed passes as rows of a timeline, one for each satellite: favourites first, then those that the schedule
// watches, then the others, each in the order in which they rise. Pure.
namespace boresight::ui {

// What the schedule makes of a pass.
enum class PassPlan
{
    None,
    Tracked,
    LeftOut  // watched, but another one is tracked, or the limits hide it
};

struct TimelineBar
{
    UtcTime rises{};
    UtcTime highest{};
    UtcTime sets{};
    Angle elevation;  // the highest
    PassPlan plan = PassPlan::None;
    std::vector<passes::Stretch> tracked = {};  // by the schedule: all of it, or what is left beside another one
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
    std::size_t leftOut = 0;  // satellites for which there is no row
};

inline constexpr std::size_t kMostTimelineRows = 40;

[[nodiscard]] Timeline timelineOf(const PassTable& passes, const orbit::SatelliteMarks& marks,
                                  const schedule::NightPlan& plan);

}  // namespace boresight::ui
