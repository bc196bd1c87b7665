// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/motion_source.h"

// All that can move this mount, but the crash-stop proof of its drives. Station thread only.
namespace boresight {

[[nodiscard]] MotionSources motionSources(Helm& helm);

}  // namespace boresight
