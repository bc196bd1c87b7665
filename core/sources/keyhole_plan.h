// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plan/plan_pass.h"
#include "core/targets/target_path.h"

#include <QFuture>

#include <optional>

// The plan for the keyhole of a pass: near the zenith the azimuth is too slow for the target, so the mount leaves the
// target early and returns late. The plan is computed on another thread, because it takes longer than a tick. Until it
// is there, and outside the keyhole, the mount follows the target itself. Elevations stay below 90°. Station thread
// only.
namespace boresight::sources {

class KeyholePlan
{
public:
    KeyholePlan() = default;  // no plan
    // Begins to compute, on copies.
    KeyholePlan(const targets::TargetPath& path, const plan::PlanTask& task, const profile::Profile& profile,
                const pointing::Antenna& antenna);

    // True once, when a plan has arrived in which the mount leaves the target.
    [[nodiscard]] bool hasArrived();
    [[nodiscard]] const plan::PlanVariant& variant() const { return *m_variant; }
    // The place of the axes at a time in the keyhole, on the turn nearest to the last place. Empty at other times.
    [[nodiscard]] std::optional<AxisPosition> placeAt(UtcTime utc, const std::optional<AxisPosition>& last) const;

private:
    QFuture<plan::PassPlan> m_future;
    std::optional<plan::PlanVariant> m_variant;
};

}  // namespace boresight::sources
