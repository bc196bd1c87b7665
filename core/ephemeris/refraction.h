// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

// Refraction by the air: everything appears a little higher than it is, by 0.5° at the horizon. The mount points to the
// apparent direction of a body, the almanac computes the true one. Pure.
//
// Light: the formula of Sæmundsson (Sky & Telescope 72, 1986, p. 70; Meeus, Astronomical Algorithms, 16.4), good to
// 0.1′ in an ordinary atmosphere. Moist air bends radio waves more, by the ratio of both refractivities at the ground.
// The one for radio waves is from recommendation ITU-R P.453, the one for light from ERFA's eraRefco.
namespace boresight::ephemeris {

enum class Refraction
{
    None,
    Light,
    Radio
};

// The station's setting: which refraction is applied to its targets.
enum class RefractionRule
{
    ByKind,  // for each target by what is received from it
    None,
    Light,
    Radio
};

// `ofKind`: the refraction for a target of this kind under ByKind.
[[nodiscard]] Refraction refractionBy(RefractionRule rule, Refraction ofKind);

// The air at the site, not reduced to sea level.
struct Air
{
    double pressureHectopascal = 1010.0;
    double temperatureCelsius = 10.0;
    double relativeHumidity = 0.5;  // 0…1

    bool operator==(const Air&) const = default;
};

// How much higher than its true elevation a direction appears. Decreases below -1° and is zero below -2°.
[[nodiscard]] Angle refraction(Angle trueElevation, Refraction kind, const Air& air = {});

// From the true to the apparent direction, and the exact inverse. Elevation -90…90°.
[[nodiscard]] SkyPointing apparent(const SkyPointing& airless, Refraction kind, const Air& air = {});
[[nodiscard]] SkyPointing airless(const SkyPointing& apparent, Refraction kind, const Air& air = {});

}  // namespace boresight::ephemeris
