// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/azel/azel_feed.h"
#include "core/ephemeris/almanac.h"

// Compares the Moon in azel.dat with our own, because WSJT-X does not notice an empty or wrong locator. Pure.
namespace boresight::azel {

// The file has steps of 0.1°, so its best accuracy is 0.07°.
inline constexpr Angle kAgrees = Angle::fromDegrees(0.2);
// The centre of a four-character locator is at most 1.2° from the station. A larger difference means another place.
inline constexpr Angle kElsewhere = Angle::fromDegrees(2.0);

enum class MoonCheck
{
    Agrees,    // our own Moon is used in place of the steps of the file
    Differs,   // WSJT-X has a coarse locator, or one that differs a little from the site
    Elsewhere  // the locator is wrong or empty, or the site is wrong
};

[[nodiscard]] MoonCheck moonCheck(Angle apart);

// The angle between the Moon of the file and our own at the time in the file. `feed` must have a text.
[[nodiscard]] Angle moonApart(const AzelFeed& feed, ephemeris::Almanac& almanac);

}  // namespace boresight::azel
