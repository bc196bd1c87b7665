// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/plan_pass.h"

#include "core/plan/pass_course.h"

#include <algorithm>
#include <array>

namespace boresight::plan {

namespace {

// Below this error a plan cannot become better by another way.
constexpr Angle kGood = Angle::fromDegrees(0.05);

void addWraps(const PlanFrame& frame, const std::optional<Course>& course, std::vector<PlanVariant>& variants)
{
    if (!course) {
        return;
    }
    const tracking::WholeTurns wraps = wrapsOf(frame.path, *course, frame.mount);
    for (int wrap = wraps.first; wrap <= wraps.last; ++wrap) {
        variants.push_back(variantOf(frame, *course, wrap));
    }
}

// At the highest point the beam can change the side. Its error is then at least the distance from the zenith.
void addCrossings(const PlanFrame& frame, std::vector<PlanVariant>& variants)
{
    constexpr std::array kCrossings{Sides{0, 1}, Sides{0, -1}, Sides{1, 0}, Sides{1, 2},
                                    Sides{0, 2}, Sides{0, -2}, Sides{1, 3}, Sides{1, -1}};
    const Angle fromZenith = 90_deg - Angle::fromRadians(frame.path.points[frame.path.top()].axes.elevation.position);
    Angle best = 90_deg;
    for (const PlanVariant& variant : variants) {
        best = std::min(best, variant.forecast.peak);
    }
    if (!frame.path.fast || best <= std::max(kGood, fromZenith)) {
        return;
    }
    for (const Sides& sides : kCrossings) {
        addWraps(frame, courseOf(frame.path, sides, frame.mount), variants);
    }
}

}  // namespace

PassPlan planPass(const DirectionAt& directionAt, const PlanTask& task, const PlanMount& mount)
{
    const PassPath path = pathOf(directionAt, task.from, task.to, mount);
    PassPlan plan{.bound = task.bound.value_or(mount.beamWidth / 2.0)};
    if (path.points.size() < 2) {
        return plan;
    }
    const PlanFrame frame{.path = path, .mount = mount, .now = task.now, .bound = plan.bound};
    const std::array whole{courseOf(path, {0, 0}, mount), courseOf(path, {1, 1}, mount)};
    for (const auto& course : whole) {
        addWraps(frame, course, plan.variants);
    }
    const bool hasRoom = !plan.variants.empty();
    addCrossings(frame, plan.variants);
    for (const auto& course : whole) {
        if (!hasRoom && course) {
            std::ranges::move(splitsOf(frame, *course), std::back_inserter(plan.variants));
        }
    }
    if (!plan.variants.empty()) {
        plan.chosen = choiceOf(plan.variants, mount.beamWidth, task.begins);
    }
    return plan;
}

}  // namespace boresight::plan
