// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/memory/reconcile.h"

#include <QString>

#include <optional>

// Did the drive keep its power since the record was made? Then it counted every turn since, also when the axis was
// moved by hand, and the absolute angle follows from the difference of two counts. Pure.
namespace boresight::memory {

// Why that cannot be shown, as a sentence for the operator; nothing: it is shown.
[[nodiscard]] std::optional<QString> obstacleToCountingOn(const DriveFrame& frame, const Evidence& evidence,
                                                          const TurnRecord& record, const pointing::AxisGeometry& axis);

}  // namespace boresight::memory
