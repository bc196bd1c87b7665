// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

// How the air bends what comes from the sky: everything appears a little higher than it is, by 0.5° at the horizon. The
// mount points to where a body appears, the almanac says where it is. Pure.
//
// Light: the formula of Sæmundsson (Sky & Telescope 72, 1986, p. 70; Meeus, Astronomical Algorithms, 16.4), good to
// 0.1′ in an ordinary atmosphere. Radio waves are bent more where the air is moist: by the ratio of both refractivities
// at the ground, that of radio waves from recommendation ITU-R P.453, that of light as in ERFA's eraRefco.
namespace boresight::ephemeris {

enum class Refraction
{
    None,
    Light,
    Radio
};

// Of a station: by what its targets are bent.
enum class RefractionRule
{
    ByKind,  // each by what is received of it
    None,
    Light,
    Radio
};

// For a target of a kind that `ofKind` is meant for.
[[nodiscard]] Refraction refractionBy(RefractionRule rule, Refraction ofKind);

// At the site, not reduced to sea level.
struct Air
{
    double pressureHectopascal = 1010.0;
    double temperatureCelsius = 10.0;
    double relativeHumidity = 0.5;  // 0…1

    bool operator==(const Air&) const = default;
};

// By how much a direction of this true elevation appears higher. Below -1° it fades, and below -2° there is none.
[[nodiscard]] Angle refraction(Angle trueElevation, Refraction kind, const Air& air = {});

// From the true direction to where it appears, and exactly back. Elevation -90…90°.
[[nodiscard]] SkyPointing apparent(const SkyPointing& airless, Refraction kind, const Air& air = {});
[[nodiscard]] SkyPointing airless(const SkyPointing& apparent, Refraction kind, const Air& air = {});

}  // namespace boresight::ephemeris
