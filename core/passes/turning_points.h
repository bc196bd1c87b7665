// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/passes/sky_track.h"

// Finds the moments of a pass between two moments that enclose them. Empty: SGP4 has no answer on the way.
namespace boresight::passes {

// The satellite is up at exactly one of the two moments. Finds where it passes the minimum elevation, to 0.1 ms.
[[nodiscard]] std::optional<SkyMoment> crossing(SkyTrack& track, const SkyMoment& a, const SkyMoment& b);
struct Limits
{
    double from = 0.0;  // s
    double to = 0.0;
};
// The satellite climbs at exactly one of the two moments. Finds the highest or lowest moment, to 1 ms. The rates that
// decide about climbing are not exact, so the result may be outside the two moments, but it is within the limits.
[[nodiscard]] std::optional<SkyMoment> turningPoint(SkyTrack& track, const SkyMoment& a, const SkyMoment& b,
                                                    Limits limits);

}  // namespace boresight::passes
