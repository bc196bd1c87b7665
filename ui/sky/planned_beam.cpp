// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/planned_beam.h"

#include "core/units/angle_between.h"

#include <algorithm>

namespace boresight::ui {

namespace {

constexpr Angle kBeamApart = Angle::fromDegrees(0.5);
constexpr Angle kBeamStep = Angle::fromDegrees(0.3);  // a plan has many more moments than pixels

}  // namespace

PlannedBeam beamOf(const plan::PlanVariant& variant, const pointing::PointingModel& pointing)
{
    std::vector<BeamMoment> moments;
    for (const plan::PlannedMoment& moment : variant.moments) {
        const BeamMoment here{.utc = moment.utc,
                              .direction = pointing::upright(pointing.toSky(moment.axes)),
                              .isApart = moment.error > kBeamApart};
        const bool isNews = moments.empty() || here.isApart != moments.back().isApart;
        if (isNews || (here.isApart && angleBetween(here.direction, moments.back().direction) > kBeamStep)) {
            moments.push_back(here);
        }
    }
    if (!moments.empty() && moments.back().isApart) {
        const plan::PlannedMoment& last = variant.moments.back();
        moments.push_back({.utc = last.utc, .direction = pointing::upright(pointing.toSky(last.axes))});
    }
    const bool hasParts = std::ranges::any_of(moments, &BeamMoment::isApart);
    return hasParts ? std::make_shared<const std::vector<BeamMoment>>(std::move(moments)) : nullptr;
}

}  // namespace boresight::ui
