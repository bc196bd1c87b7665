// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/passes/pass.h"
#include "core/schedule/watch_entry.h"

#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

// Decides which passes of a night are tracked, and which are left out because of another pass. The same passes give the
// same plan in any order. Pure, any thread.
namespace boresight::schedule {

struct WatchedPass
{
    std::int64_t number = 0;  // of the satellite in the catalogue
    int priority = 1;         // 1 is the most important
    QString name = {};
    passes::Pass pass;  // with the parts in which the antenna sees the sky
    // The only part that is tracked, because another pass is tracked before or after it. `pass.clear` ends there, too.
    std::optional<passes::Stretch> rest = {};

    [[nodiscard]] UtcTime rises() const { return rest ? rest->from : pass.aos.utc; }
    [[nodiscard]] UtcTime sets() const { return rest ? rest->to : pass.los.utc; }
    // The tracked part: from the first to the last moment in which the antenna sees the satellite.
    [[nodiscard]] bool isHidden() const { return pass.clear.empty(); }
    [[nodiscard]] UtcTime begins() const { return isHidden() ? pass.aos.utc : pass.clear.front().from; }
    [[nodiscard]] UtcTime ends() const { return isHidden() ? pass.los.utc : pass.clear.back().to; }

    bool operator==(const WatchedPass&) const = default;
};

// A repeated search finds the begin and end of the same pass at most this much earlier or later.
inline constexpr std::chrono::seconds kSamePass{30};
[[nodiscard]] inline bool isSamePass(const WatchedPass& one, const WatchedPass& other)
{
    return one.number == other.number && std::chrono::abs(one.rises() - other.rises()) < kSamePass;
}

// Why one of two passes was chosen: the first criterion that differs.
enum class Reason
{
    Priority,
    Longer,
    Earlier,
    LowerNumber
};

struct Conflict
{
    WatchedPass leftOut;
    WatchedPass chosen;
    Reason reason = Reason::Priority;
    bool overlaps = true;                     // false: the mount would not be in place for the second pass in time
    std::vector<passes::Stretch> rests = {};  // the parts of the omitted pass that are tracked

    bool operator==(const Conflict&) const = default;
};

struct NightPlan
{
    std::vector<WatchedPass> chosen;  // in the order in which they begin, with the rests of omitted passes
    std::vector<Conflict> conflicts;  // in the order in which the omitted passes begin
    std::vector<WatchedPass> hidden;  // completely behind the horizon of the mount, in a keep-out or beyond a limit

    bool operator==(const NightPlan&) const = default;
};

// A rest that is seen for less than this, from when the mount is in place for it, is not tracked.
inline constexpr Seconds kShortestRest{60.0};

struct PlanRules
{
    OverlapPolicy policy = OverlapPolicy::Priority;
    Seconds lead{60.0};  // shortest time from the end of one pass to the beginning of the next
};

// A pass that is already up when the plan begins needs no lead.
[[nodiscard]] NightPlan planNight(std::vector<WatchedPass> candidates, const PlanRules& rules);

}  // namespace boresight::schedule
