// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/memory/reconcile.h"

#include <QString>

#include <optional>

// Did the drive keep its power since the record was made, and did nobody set its position? Then it counted every turn
// since, also when the axis was moved by hand or by another tool, and the absolute angle follows from the difference of
// two counts. Pure.
namespace boresight::memory {

struct Obstacle
{
    QString why;               // a sentence for the operator
    bool restarted = false;    // it surely was without power: then its count began again, and tells nothing else
    bool positionSet = false;  // while the drive was on: the axis may have been moved and set back
    bool phaseLost = false;    // what the drive reports is not even true but for whole places
};

// Nobody set the drive's position between the two. `period`: between two places that the drive cannot tell apart.
[[nodiscard]] bool isSameOrigin(const moteus::CountOrigin& one, const moteus::CountOrigin& other, Angle period,
                                const pointing::AxisGeometry& axis);

// Why that cannot be shown; nothing: it is shown.
[[nodiscard]] std::optional<Obstacle> obstacleToCountingOn(const DriveFrame& frame, const Evidence& evidence,
                                                           const TurnRecord& record,
                                                           const pointing::AxisGeometry& axis);

}  // namespace boresight::memory
