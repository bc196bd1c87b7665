// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

// The permissions of the sample stations: everything except what is forbidden here in one sentence. They follow no
// rules: tests/core/control/permissions_test.cpp tests the rules. The window only shows the permissions.
namespace boresight::samples {

[[nodiscard]] Permissions permitted();
// Forbids all motion except Hold; all motion and Hold; only pointing.
[[nodiscard]] Permissions withoutMoves(const QString& why, Permissions may = permitted());
[[nodiscard]] Permissions withoutMotion(const QString& why, Permissions may = permitted());
[[nodiscard]] Permissions withoutPointing(const QString& why, Permissions may = permitted());
// Forbids what needs a mount that stands still.
[[nodiscard]] Permissions inMotion(Permissions may = permitted());

// Adds the permissions of the calibration and the direction of the beam, as a station computes them.
[[nodiscard]] StationStatus judged(StationStatus status);

}  // namespace boresight::samples
