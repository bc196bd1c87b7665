// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "core/pointing/mount_model.h"

#include <vector>

// Where the beam points, from what the axes do. Pure, any thread.
namespace boresight {

// To what `status` has of the axes. One angle of a skewed model needs both of them.
void addBeam(StationStatus& status, const pointing::PointingModel& model);
// Straight in both axes from corner to corner, in steps that are fine enough to be drawn.
[[nodiscard]] std::vector<SkyPointing> beamPath(const pointing::MountModel& model,
                                                const std::vector<AxisPosition>& corners);

}  // namespace boresight
