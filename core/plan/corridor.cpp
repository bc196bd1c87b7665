// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/corridor.h"

#include "core/plan/state_set.h"

#include <algorithm>

namespace boresight::plan {

using tracking::MotionBounds;
using tracking::MotionState;

namespace {

StateSet firstSet(const Gate& gate, const WayEnds& ends, const MotionBounds& bounds)
{
    return ends.first ? StateSet::only(*ends.first) : StateSet::box(gate.low, gate.high, bounds.speed);
}

StateSet nextSet(const StateSet& now, const Gate& here, const Gate& next, const MotionBounds& bounds)
{
    return now.later(next.seconds - here.seconds, bounds.acceleration).within(next.low, next.high, bounds.speed);
}

}  // namespace

bool hasWay(std::span<const Gate> gates, const WayEnds& ends, const MotionBounds& bounds)
{
    StateSet now = firstSet(gates.front(), ends, bounds);
    for (std::size_t i = 1; i < gates.size() && !now.empty(); ++i) {
        now = nextSet(now, gates[i - 1], gates[i], bounds);
    }
    return !now.empty() && (!ends.last || now.contains(*ends.last));
}

std::optional<std::vector<MotionState>> wayThrough(std::span<const Gate> gates, const WayEnds& ends,
                                                   const MotionBounds& bounds)
{
    std::vector<StateSet> reached{firstSet(gates.front(), ends, bounds)};
    reached.reserve(gates.size());
    for (std::size_t i = 1; i < gates.size(); ++i) {
        reached.push_back(nextSet(reached.back(), gates[i - 1], gates[i], bounds));
        if (reached.back().empty()) {
            return std::nullopt;
        }
    }
    if (ends.last && !reached.back().contains(*ends.last)) {
        return std::nullopt;
    }
    std::vector<MotionState> way(gates.size());
    const double lastStep = gates.size() > 1 ? gates.back().seconds - gates[gates.size() - 2].seconds : 1.0;
    way.back() = ends.last ? *ends.last : reached.back().closest(gates.back().wish, lastStep);
    for (std::size_t i = gates.size() - 1; i > 0; --i) {
        way[i - 1] = reached[i - 1].before(way[i], gates[i].seconds - gates[i - 1].seconds, bounds.acceleration,
                                           gates[i - 1].wish);
    }
    return way;
}

}  // namespace boresight::plan
