// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/roomy_start.h"

#include <algorithm>
#include <cmath>

namespace boresight::sources {

std::optional<AxisPosition> roomyStart(const ControlParts& view, const std::vector<targets::SkyMoment>& way)
{
    std::optional<AxisPosition> first;
    TravelRange swept;
    Angle last;
    for (const targets::SkyMoment& moment : way) {
        const AxisPosition axes = view.model.pointing().toAxes(moment.direction).axes;
        last = first ? axes.azimuth.nearestTo(last) : axes.azimuth;
        swept = first ? TravelRange{std::min(swept.min, last), std::max(swept.max, last)} : TravelRange{last, last};
        first = first.value_or(axes);
    }
    if (!first) {
        return std::nullopt;
    }
    const TravelRange& range = view.motion.region().ranges().azimuth;
    const AxisPosition heading = view.heading();
    std::optional<AxisPosition> best;
    const auto mostTurns = static_cast<int>(std::floor((range.max - swept.max).turns()));
    for (int turns = static_cast<int>(std::ceil((range.min - swept.min).turns())); turns <= mostTurns; ++turns) {
        const AxisPosition start{first->azimuth + Angle::fromTurns(turns), first->elevation};
        const auto distance = [&](const AxisPosition& to) { return abs(to.azimuth - heading.azimuth); };
        if (!best || distance(start) < distance(*best)) {
            best = start;
        }
    }
    return best;
}

}  // namespace boresight::sources
