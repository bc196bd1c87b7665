// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pointing/permitted_region.h"
#include "core/tuning/tuning_legs.h"

// Where a tuning run would move an axis from here, and whether there is enough room. Pure.
namespace boresight {

struct TuningWay
{
    TuningPlan plan;
    double way = 1.0;  // 1 or -1: towards the side with more room
    std::vector<TuningLeg> legs;
};

[[nodiscard]] TuningWay planTuning(TuningRun run, Axis axis, const AxisPosition& here,
                                   const pointing::PermittedRegion& region, const tracking::MotionLimits& limits);

}  // namespace boresight
