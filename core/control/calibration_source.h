// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

// Who asks for the motions of calibrations: the operator, but not the operator's own hand, which ends them. Such a
// motion is asked for again and again by its source. Station thread.
namespace boresight {

[[nodiscard]] const Source& calibrationSource();
// The same for the runs by which the axes are tuned.
[[nodiscard]] const Source& tuningSource();

}  // namespace boresight
