// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/passes/pass_book.h"

#include <optional>

namespace boresight::ui {

// The plan by which the mount drives this pass. Null: it tracks something else, for example an earlier pass of the
// satellite, or there is no plan.
[[nodiscard]] inline plan::SharedVariant drivenPlan(const std::optional<TrackedTarget>& tracked, const PassBook& book,
                                                    const BookedPass& one)
{
    const bool isPlanned = tracked && tracked->number == book.elementsOf(one).number && tracked->plan;
    const bool isThisPass = isPlanned && tracked->plan->moments.front().utc < one.pass.los.utc &&
                            tracked->plan->moments.back().utc > one.pass.aos.utc;
    return isThisPass ? tracked->plan : nullptr;
}

}  // namespace boresight::ui
