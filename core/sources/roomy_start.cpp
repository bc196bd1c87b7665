// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/roomy_start.h"

#include "core/tracking/cable_room.h"

namespace boresight::sources {

std::optional<AxisPosition> roomyStart(const ControlParts& view, const std::vector<targets::SkyMoment>& way)
{
    std::optional<AxisPosition> first;
    tracking::SweptArc arc;
    for (const targets::SkyMoment& moment : way) {
        const AxisPosition axes = view.model.pointing().toAxes(moment.direction).axes;
        arc.add(axes.azimuth);
        first = first.value_or(axes);
    }
    const tracking::WholeTurns turns = arc.turnsInside(view.motion.region().ranges().azimuth);
    const AxisPosition from = view.stoppingPlace();
    std::optional<AxisPosition> best;
    for (int turn = turns.first; turn <= turns.last; ++turn) {
        const AxisPosition start{first->azimuth + Angle::fromTurns(turn), first->elevation};
        const auto distance = [&](const AxisPosition& to) { return abs(to.azimuth - from.azimuth); };
        if (!best || distance(start) < distance(*best)) {
            best = start;
        }
    }
    return best;
}

}  // namespace boresight::sources
