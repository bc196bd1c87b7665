// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

// What the stations of the samples permit: everything but what is forbidden here in one sentence. No rules: those are
// tested where they are, in tests/core/control/permissions_test.cpp. The window only shows them.
namespace boresight::samples {

[[nodiscard]] Permissions permitted();
// Nothing that moves the mount but Hold; nor Hold; only what points it somewhere.
[[nodiscard]] Permissions withoutMoves(const QString& why, Permissions may = permitted());
[[nodiscard]] Permissions withoutMotion(const QString& why, Permissions may = permitted());
[[nodiscard]] Permissions withoutPointing(const QString& why, Permissions may = permitted());
// Nothing that needs a mount at rest: it moves.
[[nodiscard]] Permissions inMotion(Permissions may = permitted());

// With what the calibration permits, and where the beam is: both as a station works it out.
[[nodiscard]] StationStatus judged(StationStatus status);

}  // namespace boresight::samples
