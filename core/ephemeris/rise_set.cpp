// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ephemeris/rise_set.h"

namespace boresight::ephemeris {

namespace {

constexpr std::chrono::minutes kStep{5};
constexpr std::chrono::seconds kExact{1};

// From a time when `is` does not hold to one when it does.
template <class Is>
std::optional<UtcTime> firstTime(UtcTime from, Is is)
{
    bool before = is(from);
    for (UtcTime next = from + kStep; next <= from + kRiseSearch; next += kStep) {
        const bool now = is(next);
        if (now && !before) {
            UtcTime early = next - kStep;
            UtcTime late = next;
            while (late - early > kExact) {
                const UtcTime middle = early + (late - early) / 2;
                (is(middle) ? late : early) = middle;
            }
            return late;
        }
        before = now;
    }
    return std::nullopt;
}

}  // namespace

std::optional<UtcTime> nextRise(Almanac& almanac, Body body, UtcTime from, Angle elevation)
{
    return firstTime(from, [&](UtcTime utc) { return almanac.place(body, utc).direction.elevation > elevation; });
}

std::optional<UtcTime> nextSet(Almanac& almanac, Body body, UtcTime from, Angle elevation)
{
    return firstTime(from, [&](UtcTime utc) { return almanac.place(body, utc).direction.elevation <= elevation; });
}

}  // namespace boresight::ephemeris
