// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/passes/sky_track.h"

// The moments that a pass is made of, between two others that enclose them. Empty: the theory has no answer on the way.
namespace boresight::passes {

// One of the two is up, the other is not: where the minimum elevation is passed, to 0.1 ms.
[[nodiscard]] std::optional<SkyMoment> crossing(SkyTrack& track, const SkyMoment& a, const SkyMoment& b);
struct Limits
{
    double from = 0.0;  // s
    double to = 0.0;
};
// One of the two climbs, the other does not: the highest or the lowest moment, to 1 ms. The rates by which they climb
// may be so far off that it is not between them, but it is within the limits.
[[nodiscard]] std::optional<SkyMoment> turningPoint(SkyTrack& track, const SkyMoment& a, const SkyMoment& b,
                                                    Limits limits);

}  // namespace boresight::passes
