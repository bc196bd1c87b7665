// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QString>

// Why a control of the operator cannot act now, in words for its tooltip; empty when it can. The station decides
// again: this only keeps the screen from offering what would be refused.
namespace boresight::ui {

enum class JogDirection
{
    Up,
    Down,
    Left,  // counter-clockwise: azimuth gets smaller
    Right
};

[[nodiscard]] QString whyNoPlace(const StationStatus& status, Axis axis);  // known, where the axis stands
[[nodiscard]] QString whyNoMotion(const StationStatus& status);
[[nodiscard]] QString whyNoPointing(const StationStatus& status);  // to an angle: needs the turn of both axes
[[nodiscard]] QString whyNoJog(const StationStatus& status, JogDirection direction);  // at a limit: the way on
[[nodiscard]] QString whyNoStep(const StationStatus& status, JogDirection direction);
// By hand: less while nobody knows the turn of an axis, or which way the axes turn.
[[nodiscard]] AngularRate fastestJog(const StationStatus& status);
[[nodiscard]] QString whyNoUnwind(const StationStatus& status);
[[nodiscard]] bool followsAClient(const StationStatus& status);  // a step then trims the client's target
[[nodiscard]] bool isMoving(const StationStatus& status);

}  // namespace boresight::ui
