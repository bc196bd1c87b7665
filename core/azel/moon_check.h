// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/azel/azel_feed.h"
#include "core/ephemeris/almanac.h"

// How the Moon of azel.dat compares with our own: WSJT-X does not notice a blank or wrong locator. Pure.
namespace boresight::azel {

// The steps of the file are 0.1° wide, so it is right by 0.07° at best.
inline constexpr Angle kAgrees = Angle::fromDegrees(0.2);
// The centre of a locator of four characters is at most 1.2° from the station. What is farther away is another place.
inline constexpr Angle kElsewhere = Angle::fromDegrees(2.0);

enum class MoonCheck
{
    Agrees,    // our own Moon stands for the file's, between its steps
    Differs,   // the locator of WSJT-X is a coarse one, or differs a little from the site
    Elsewhere  // the locator is wrong or blank, or the site is
};

[[nodiscard]] MoonCheck moonCheck(Angle apart);

// How far the Moon of the file, which has a text, is from our own at the time that the file shows.
[[nodiscard]] Angle moonApart(const AzelFeed& feed, ephemeris::Almanac& almanac);

}  // namespace boresight::azel
