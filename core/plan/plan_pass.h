// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plan/pass_path.h"
#include "core/plan/pass_plan.h"

#include <optional>

// Plans a whole pass before it begins: the wrap of the cable, direct or over the top, the start position, the way
// through the keyhole, and the moment of an unwrap if no wrap has room. Pure, any thread. A call takes some
// milliseconds, and up to a second for a pass through the keyhole.
namespace boresight::plan {

struct PlanTask
{
    UtcTime from{};
    UtcTime to{};
    AxisPosition now{};            // where the axes are before the pass
    std::optional<Angle> bound{};  // of the error; empty: half of the beam width, where a signal loses 3 dB
    Begins begins = Begins::Later;
};

[[nodiscard]] PassPlan planPass(const DirectionAt& directionAt, const PlanTask& task, const PlanMount& mount);

}  // namespace boresight::plan
