// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/motion_source.h"

// Everything that can move this mount, except the crash-stop test of its drives. Station thread only.
namespace boresight {

[[nodiscard]] MotionSources motionSources(Helm& helm);

}  // namespace boresight
