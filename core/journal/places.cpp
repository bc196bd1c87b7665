// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/journal/places.h"

#include <cmath>

namespace boresight::journal {

std::vector<Angle> placesAround(Angle reported, Angle period, const TravelRange& travel)
{
    std::vector<Angle> places;
    const double first = std::ceil((travel.min - kBeyondTravel - reported) / period);
    const double last = std::floor((travel.max + kBeyondTravel - reported) / period);
    constexpr double kMost = 1e6;
    if (!(first <= last && last - first < kMost)) {
        return places;  // none, or not a number
    }
    for (int i = 0; i <= static_cast<int>(last - first); ++i) {
        places.push_back(reported + period * (first + i));
    }
    return places;
}

}  // namespace boresight::journal
