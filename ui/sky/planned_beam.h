// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plan/pass_plan.h"
#include "core/pointing/pointing_model.h"

#include <memory>
#include <vector>

// Where a plan leads the beam, for the sky: only the places at which the beam is not at the target. Pure.
namespace boresight::ui {

struct BeamMoment
{
    UtcTime utc{};
    SkyPointing direction{};  // upright
    bool isApart = false;     // farther than half a degree from the target, from here to the next moment

    bool operator==(const BeamMoment&) const = default;
};

// In the order of time. Never changed. Null: the beam is at the target all the time.
using PlannedBeam = std::shared_ptr<const std::vector<BeamMoment>>;

[[nodiscard]] PlannedBeam beamOf(const plan::PlanVariant& variant, const pointing::PointingModel& pointing);

}  // namespace boresight::ui
