// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ephemeris/rise_set.h"

#include <algorithm>

namespace boresight::ephemeris {

namespace {

constexpr std::chrono::seconds kExact{1};
// The sky turns by 15.04° in an hour. The Moon's own motion and its parallax add less than a degree.
constexpr Angle kMostInAnHour = Angle::fromDegrees(16.0);

// The first time at which the height above the wanted elevation becomes positive. The height cannot change faster than
// kMostInAnHour, so most of the time is skipped.
template <class Height>
std::optional<UtcTime> firstTime(UtcTime from, Height height)
{
    UtcTime early = from;
    Angle there = height(early);
    const UtcTime end = from + kRiseSearch;
    while (early < end) {
        const Seconds away = std::max<Seconds>(kShortestUp, abs(there) / kMostInAnHour * std::chrono::hours(1));
        UtcTime late = std::min(end, early + std::chrono::duration_cast<UtcTime::duration>(away));
        const Angle then = height(late);
        if (there <= Angle{} && then > Angle{}) {
            while (late - early > kExact) {
                const UtcTime middle = early + (late - early) / 2;
                (height(middle) > Angle{} ? late : early) = middle;
            }
            return late;
        }
        early = late;
        there = then;
    }
    return std::nullopt;
}

}  // namespace

std::optional<UtcTime> nextRise(Almanac& almanac, const SkyObject& object, UtcTime from, Angle elevation)
{
    return firstTime(from, [&](UtcTime utc) { return see(almanac, object, utc).direction.elevation - elevation; });
}

std::optional<UtcTime> nextSet(Almanac& almanac, const SkyObject& object, UtcTime from, Angle elevation)
{
    return firstTime(from, [&](UtcTime utc) { return elevation - see(almanac, object, utc).direction.elevation; });
}

}  // namespace boresight::ephemeris
