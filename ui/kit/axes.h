// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QString>

#include <optional>

// The status of one axis, and whether its wrap is known.
namespace boresight::ui {

[[nodiscard]] QString name(Axis axis);       // "azimuth"
[[nodiscard]] QString shortName(Axis axis);  // "AZ"
// "AZ", or "X" for an X/Y mount. Only for angles of the axis itself: directions are always AZ and EL.
[[nodiscard]] QString shortName(Axis axis, const StationStatus& status);
[[nodiscard]] bool hasXY(const StationStatus& status);
[[nodiscard]] std::size_t axisIndex(Axis axis);  // 0, 1
// The axis that the mount does not have.
[[nodiscard]] std::optional<Axis> missingAxis(const StationStatus& status);
[[nodiscard]] const AxisStatus& axisOf(const StationStatus& status, Axis axis);
// For a mount without drives that can be read, all values are unknown.
[[nodiscard]] const DrivesStatus& drivesOf(const StationStatus& status);
[[nodiscard]] const DriveStatus& driveOf(const StationStatus& status, Axis axis);
// True also for a rotator without such drives that reports nothing now, because it counts the turns itself.
[[nodiscard]] bool isTurnKnown(const StationStatus& status, Axis axis);
// The drive check, which may find the wrap, has not ended: nothing is shown about the wrap yet.
[[nodiscard]] bool isTurnAwaited(const StationStatus& status, Axis axis);
[[nodiscard]] bool areTurnsKnown(const StationStatus& status);
// The axis whose wrap the operator is asked for. If both ask, azimuth comes first.
[[nodiscard]] std::optional<Axis> askingAxis(const StationStatus& status);

}  // namespace boresight::ui
