// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <vector>

// The way that the beam will really go to a fixed target: the route around what is forbidden, or the direct way of both
// axes, each at its own speed and over as many turns as the cable takes. For drawing only: the station decides the way.
namespace boresight::ui {

// Empty without a slew, and while nobody knows where the set-point is.
[[nodiscard]] std::vector<SkyPointing> slewWay(const StationStatus& status);
[[nodiscard]] bool isSlewing(const StationStatus& status);

}  // namespace boresight::ui
