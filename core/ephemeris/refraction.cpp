// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ephemeris/refraction.h"

#include <algorithm>
#include <cmath>

namespace boresight::ephemeris {

namespace {

constexpr Angle kFades = Angle::fromDegrees(-1.0);
constexpr Angle kGone = Angle::fromDegrees(-2.0);
constexpr double kFreezing = 273.15;  // K

// Pressure of saturated water vapour, hPa (Buck 1996, as in ITU-R P.453).
double saturation(double celsius)
{
    return 6.1121 * std::exp((18.678 - celsius / 234.5) * celsius / (257.14 + celsius));
}

// Ratio of the refraction of radio waves to that of light with 0.55 µm, for the air at the ground.
double radioToLight(const Air& air)
{
    const double kelvin = kFreezing + air.temperatureCelsius;
    const double water = air.relativeHumidity * saturation(air.temperatureCelsius);
    const double dry = air.pressureHectopascal - water;
    const double radio = (77.6 * dry + 72.0 * water + 3.75e5 * water / kelvin) / kelvin;
    const double light = (79.03 * air.pressureHectopascal - 11.27 * water) / kelvin;
    return radio / light;
}

Angle saemundsson(Angle trueElevation)
{
    const double degrees = trueElevation.degrees();
    const Angle argument = Angle::fromDegrees(degrees + 10.3 / (degrees + 5.11));
    return Angle::fromDegrees(std::max(0.0, 1.02 / 60.0 / std::tan(argument.radians())));
}

}  // namespace

Refraction refractionBy(RefractionRule rule, Refraction ofKind)
{
    switch (rule) {
        case RefractionRule::ByKind:
            return ofKind;
        case RefractionRule::None:
            return Refraction::None;
        case RefractionRule::Light:
            return Refraction::Light;
        case RefractionRule::Radio:
            return Refraction::Radio;
    }
    return ofKind;
}

Angle refraction(Angle trueElevation, Refraction kind, const Air& air)
{
    if (kind == Refraction::None || trueElevation <= kGone) {
        return {};
    }
    const double there = std::min(1.0, (trueElevation - kGone) / (kFades - kGone));
    const double density = air.pressureHectopascal / 1010.0 * 283.0 / (273.0 + air.temperatureCelsius);
    const double wave = kind == Refraction::Radio ? radioToLight(air) : 1.0;
    return there * density * wave * saemundsson(std::max(trueElevation, kFades));
}

SkyPointing apparent(const SkyPointing& airless, Refraction kind, const Air& air)
{
    return {.azimuth = airless.azimuth, .elevation = airless.elevation + refraction(airless.elevation, kind, air)};
}

// The apparent elevation grows with the true one, so bisection finds the true elevation.
SkyPointing airless(const SkyPointing& apparent, Refraction kind, const Air& air)
{
    Angle low = apparent.elevation - 3_deg;
    Angle high = apparent.elevation;
    for (int i = 0; i < 50; ++i) {
        const Angle middle = (low + high) / 2.0;
        (middle + refraction(middle, kind, air) < apparent.elevation ? low : high) = middle;
    }
    return {.azimuth = apparent.azimuth, .elevation = high};
}

}  // namespace boresight::ephemeris
