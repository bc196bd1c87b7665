// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ephemeris/sky_object.h"

#include <chrono>
#include <optional>

// When the Sun, the Moon, a planet or a star comes up next and goes down next, for the operator who waits for it. Pure.
namespace boresight::ephemeris {

// Longer than from one rise of the Moon to the next wherever it rises each day.
inline constexpr std::chrono::hours kRiseSearch{26};
// What is up, or down, for less than this may be passed over: so near to the horizon no search looks closer.
inline constexpr std::chrono::minutes kShortestUp{10};

// The next time, to the second, that the centre of the disc passes a true elevation upwards, or downwards. Empty if it
// does not within kRiseSearch.
[[nodiscard]] std::optional<UtcTime> nextRise(Almanac& almanac, const SkyObject& object, UtcTime from, Angle elevation);
[[nodiscard]] std::optional<UtcTime> nextSet(Almanac& almanac, const SkyObject& object, UtcTime from, Angle elevation);

}  // namespace boresight::ephemeris
