// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/control_parts.h"
#include "core/plan/plan_pass.h"
#include "core/targets/target_path.h"

#include <QFuture>

#include <optional>

// How the mount drives a pass: by a plan of core/plan. The plan is computed on another thread, because it takes longer
// than a tick. The mount follows the target itself, on the wrap and the side of the plan. In the keyhole, and while it
// waits at the end of the cable, it moves as the plan does. Station thread only.
namespace boresight::sources {

struct PlanFound
{
    plan::SharedVariant variant;  // null: there is no plan
    bool isAsWanted = true;       // false: the plan does not have the way that was asked for
};

class PassDrive
{
public:
    // Begins to compute, on copies. The former plan is driven until then. A mount that needs no plan gets none. Drives
    // by the wanted way. If it is empty, or the plan does not have it, by the best one.
    void compute(const targets::TargetPath& path, const plan::PlanTask& task,
                 const std::optional<plan::ChosenWay>& wanted, const ControlParts& view);

    // Once, when a plan has arrived: whether it has the wanted way. The variant may be null then.
    [[nodiscard]] std::optional<bool> hasArrived();
    // Null: no plan, or not yet.
    [[nodiscard]] const plan::SharedVariant& variant() const { return m_variant; }
    // These need a variant. Where the axes are by the plan; empty: the mount follows the target itself.
    [[nodiscard]] std::optional<AxisPosition> placeAt(UtcTime utc) const;
    // A place on the wrap, and on the side of the zenith, on which the mount follows the target.
    [[nodiscard]] AxisPosition sideAt(UtcTime utc) const;
    // The mount is on its way to another wrap.
    [[nodiscard]] bool unwrapsAt(UtcTime utc) const;

private:
    QFuture<PlanFound> m_future;
    plan::SharedVariant m_variant;
};

}  // namespace boresight::sources
