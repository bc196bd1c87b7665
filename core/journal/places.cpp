// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/journal/places.h"

#include <cmath>

namespace boresight::journal {

std::vector<Angle> placesAround(Angle reported, Angle period, const TravelRange& travel)
{
    std::vector<Angle> places;
    const double first = std::ceil((travel.min - kBeyondTravel - reported) / period);
    const double last = std::floor((travel.max + kBeyondTravel - reported) / period);
    for (double k = first; k <= last; k += 1.0) {
        places.push_back(reported + period * k);
    }
    return places;
}

}  // namespace boresight::journal
