// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/passes/sky_track.h"

// The parts of a pass in which the antenna sees the satellite above its horizon and outside its keep-outs.
namespace boresight::passes {

// The path is tested every 0.25°. A shorter gap or obstacle can be missed. The ends are found to 1 ms.
[[nodiscard]] std::vector<Stretch> clearStretches(SkyTrack& track, double fromSeconds, double toSeconds,
                                                  const std::function<bool(const SkyPointing&)>& isClear);

}  // namespace boresight::passes
