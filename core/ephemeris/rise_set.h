// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ephemeris/sky_object.h"

#include <chrono>
#include <optional>

// The next rise and set of the Sun, the Moon, a planet or a star. Pure.
namespace boresight::ephemeris {

// Longer than the time between two rises of the Moon, where it rises every day.
inline constexpr std::chrono::hours kRiseSearch{26};
// A body that is up or down for a shorter time may be missed, because the search takes no shorter steps near the
// horizon.
inline constexpr std::chrono::minutes kShortestUp{10};

// The next time, to the second, at which the centre of the disc rises above or sets below a true elevation. Empty if it
// does not within kRiseSearch.
[[nodiscard]] std::optional<UtcTime> nextRise(Almanac& almanac, const SkyObject& object, UtcTime from, Angle elevation);
[[nodiscard]] std::optional<UtcTime> nextSet(Almanac& almanac, const SkyObject& object, UtcTime from, Angle elevation);

}  // namespace boresight::ephemeris
