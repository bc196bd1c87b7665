// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QString>

#include <optional>

// What the status says of one axis, found by the axis; and whether its absolute turn is known.
namespace boresight::ui {

[[nodiscard]] QString name(Axis axis);           // "azimuth"
[[nodiscard]] QString shortName(Axis axis);      // "AZ"
[[nodiscard]] std::size_t axisIndex(Axis axis);  // 0, 1
// The axis that the mount does not have.
[[nodiscard]] std::optional<Axis> missingAxis(const StationStatus& status);
[[nodiscard]] const AxisStatus& axisOf(const StationStatus& status, Axis axis);
// A mount without such drives has blank ones: nothing is known of them.
[[nodiscard]] const DrivesStatus& drivesOf(const StationStatus& status);
[[nodiscard]] const DriveStatus& driveOf(const StationStatus& status, Axis axis);
// Also of a rotator without such drives that reports nothing now: it counts the turns itself.
[[nodiscard]] bool isTurnKnown(const StationStatus& status, Axis axis);
// The survey of the drives, which may tell the turn, has not ended: nothing is said about it yet.
[[nodiscard]] bool isTurnAwaited(const StationStatus& status, Axis axis);
[[nodiscard]] bool areTurnsKnown(const StationStatus& status);
// The axis whose turn the operator is asked for; when both ask, azimuth comes first.
[[nodiscard]] std::optional<Axis> askingAxis(const StationStatus& status);

}  // namespace boresight::ui
