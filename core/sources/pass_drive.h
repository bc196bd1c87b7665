// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/control_parts.h"
#include "core/plan/plan_pass.h"
#include "core/targets/target_path.h"

#include <QFuture>

#include <optional>

// How the mount drives a pass: by a plan of core/plan. The plan is computed on another thread, because it takes longer
// than a tick. Until it is there the mount follows the target itself. If the plan is the direct way, the mount does so
// outside the keyhole, too. Station thread only.
namespace boresight::sources {

class PassDrive
{
public:
    // Begins to compute, on copies. The former plan is driven until then. A mount that needs no plan gets none.
    void compute(const targets::TargetPath& path, const plan::PlanTask& task, const ControlParts& view);

    // True once, when a plan has arrived. Drives by this way of it. If it is empty, or the plan does not have it, by
    // the best one.
    [[nodiscard]] bool hasArrived(const std::optional<plan::ChosenWay>& wanted);
    // Null: no plan, or not yet.
    [[nodiscard]] const plan::SharedVariant& variant() const { return m_variant; }
    // Where the axes are by the plan. Empty: the mount follows the target itself.
    [[nodiscard]] std::optional<AxisPosition> placeAt(UtcTime utc) const;

private:
    QFuture<plan::PassPlan> m_future;
    plan::SharedVariant m_variant;
};

}  // namespace boresight::sources
