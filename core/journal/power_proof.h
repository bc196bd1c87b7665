// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/journal/reconcile.h"

#include <QString>

#include <optional>

// Whether the drive kept its power since the record was made, and its position was not set. If so, the drive counted
// every turn since, also when the axis was moved by hand or by another tool. Then the absolute angle follows from the
// difference of two counts. Pure.
namespace boresight::journal {

struct Obstacle
{
    QString why;               // a sentence for the operator
    bool restarted = false;    // the drive certainly lost its power, so its count began again and proves nothing
    bool positionSet = false;  // set while the drive was on: the axis may have been moved and set back
    bool phaseLost = false;    // the reported position is not even correct to whole periods
};

// True if the drive's position was not set between the two. `period`: between two angles that the drive cannot
// distinguish.
[[nodiscard]] bool isSameOrigin(const moteus::CountOrigin& one, const moteus::CountOrigin& other, Angle period,
                                const pointing::AxisGeometry& axis);

// Why this cannot be proved. Empty: it is proved.
[[nodiscard]] std::optional<Obstacle> obstacleToCountingOn(const DriveFrame& frame, const Evidence& evidence,
                                                           const TurnRecord& record,
                                                           const pointing::AxisGeometry& axis);

}  // namespace boresight::journal
