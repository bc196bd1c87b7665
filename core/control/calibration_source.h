// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

// The source of the motions of a calibration. It is the operator, but not the operator's own hand: a motion by hand
// ends the motions of a calibration. Station thread.
namespace boresight {

[[nodiscard]] const Source& calibrationSource();
// The source of the motions by which the axes are tuned.
[[nodiscard]] const Source& tuningSource();

}  // namespace boresight
