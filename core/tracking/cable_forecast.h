// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/target_stream.h"

#include <optional>
#include <vector>

// Where a path that is followed will lead beyond the range of the azimuth, told in time. The path is taken to go on as
// a great circle through the sky with its present speed: near the zenith an azimuth rate of this moment says nothing
// about the next minute. Pure.
namespace boresight::tracking {

struct CableForecast
{
    Angle end;   // the end of the range that will be reached
    Seconds in;  // from now
    Angle left;  // from the target of now to it
};

// Empty: the target sets, or turns back, before it comes there; or it stands.
[[nodiscard]] std::optional<CableForecast> forecastCableEnd(const MovingTarget& target, const TravelRange& azimuths);

// A path that is known ahead, as a satellite's is. The azimuth is counted beyond 360°.
struct PathMoment
{
    Seconds in;  // from now
    Angle azimuth;
    bool isReachable = true;  // the limits do not hide it
};

// How much of the path the mount loses if it waits at the end of the range until the path comes back. What the limits
// hide is lost anyway, and does not count. Between two moments the azimuth is taken to run evenly.
[[nodiscard]] Seconds timeBeyond(const std::vector<PathMoment>& path, const TravelRange& azimuths);

}  // namespace boresight::tracking
