// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "core/pointing/mount_model.h"

#include <vector>

// Where the beam points, computed from the angles of the axes. Pure, any thread.
namespace boresight {

// Adds the beam angles to the axis angles that `status` has. With a skewed model each beam angle needs both axes.
void addBeam(StationStatus& status, const pointing::PointingModel& model);
// The directions of the beam along this path of the axes. Between two corners both axes move in a straight line. The
// steps are fine enough to be drawn.
[[nodiscard]] std::vector<SkyPointing> beamPath(const pointing::MountModel& model,
                                                const std::vector<AxisPosition>& corners);

}  // namespace boresight
