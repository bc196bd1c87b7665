// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/target_stream.h"

#include <optional>
#include <vector>

// Predicts when a tracked path will leave the range of the azimuth. It assumes that the path continues as a great
// circle through the sky with its present speed. Near the zenith the present azimuth rate would not predict even the
// next minute. Pure.
namespace boresight::tracking {

struct CableForecast
{
    Angle end;   // the end of the range that will be reached
    Seconds in;  // from now
    Angle left;  // angle from the present target to the end
};

// Empty if the target stands still, or if it sets or turns back before it reaches the end.
[[nodiscard]] std::optional<CableForecast> forecastCableEnd(const MovingTarget& target, const TravelRange& azimuths);

// One moment of a path that is known in advance, for example of a satellite. The azimuth is unwrapped and may exceed
// 360°.
struct PathMoment
{
    Seconds in;  // from now
    Angle azimuth;
    bool isReachable = true;  // false: the limits hide it
};

// The part of the path that the mount loses if it waits at the end of the range until the path comes back. The parts
// that the limits hide are lost anyway and do not count. The azimuth is taken as linear between two moments.
[[nodiscard]] Seconds timeBeyond(const std::vector<PathMoment>& path, const TravelRange& azimuths);

}  // namespace boresight::tracking
