// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/target_stream.h"

#include <optional>

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

}  // namespace boresight::tracking
