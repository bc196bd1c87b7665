// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/azel/moon_check.h"

#include "core/units/angle_between.h"

namespace boresight::azel {

MoonCheck moonCheck(Angle apart)
{
    return apart <= kAgrees ? MoonCheck::Agrees : apart <= kElsewhere ? MoonCheck::Differs : MoonCheck::Elsewhere;
}

Angle moonApart(const AzelFeed& feed, ephemeris::Almanac& almanac)
{
    return angleBetween(feed.text()->moon, almanac.place(ephemeris::Body::Moon, feed.time()).direction);
}

}  // namespace boresight::azel
