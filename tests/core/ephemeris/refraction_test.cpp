// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ephemeris/refraction.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace boresight;
using namespace boresight::ephemeris;

namespace {

double arcMinutes(Angle trueElevation, Refraction kind = Refraction::Light, const Air& air = {})
{
    return 60.0 * refraction(trueElevation, kind, air).degrees();
}

// From the apparent elevation (Bennett, Journal of Navigation 35, 1982, p. 255), in arc minutes.
double bennett(double degrees)
{
    return 1.0 / std::tan(Angle::fromDegrees(degrees + 7.31 / (degrees + 4.4)).radians());
}

}  // namespace

// Sæmundsson's values at 1010 hPa and 10 °C.
// REQ-EPHEMERIS-05: The refraction of light is as published. That of radio waves is larger with moisture.
TEST(Refraction, OfLightHasItsKnownValues)
{
    EXPECT_NEAR(arcMinutes(0_deg), 29.0, 0.1);
    EXPECT_NEAR(arcMinutes(1_deg), 21.7, 0.1);
    EXPECT_NEAR(arcMinutes(2_deg), 16.9, 0.1);
    EXPECT_NEAR(arcMinutes(5_deg), 9.7, 0.1);
    EXPECT_NEAR(arcMinutes(10_deg), 5.4, 0.1);
    EXPECT_NEAR(arcMinutes(20_deg), 2.7, 0.1);
    EXPECT_NEAR(arcMinutes(45_deg), 1.0, 0.05);
    EXPECT_NEAR(arcMinutes(90_deg), 0.0, 0.003);
}

// REQ-EPHEMERIS-05
TEST(Refraction, GrowsWithTheDensityOfTheAir)
{
    EXPECT_NEAR(arcMinutes(10_deg, Refraction::Light, {.pressureHectopascal = 505.0}), arcMinutes(10_deg) / 2.0, 1e-9);
    EXPECT_GT(arcMinutes(10_deg, Refraction::Light, {.temperatureCelsius = -20.0}), arcMinutes(10_deg));
}

// REQ-EPHEMERIS-06
TEST(Refraction, CanBeLeftOut)
{
    const SkyPointing low{.azimuth = 123_deg, .elevation = 0.5_deg};
    EXPECT_EQ(apparent(low, Refraction::None), low);
    EXPECT_NEAR(airless(low, Refraction::None).elevation.degrees(), 0.5, 1e-12);
}

// For radio waves 13.5′ at 5° where it is hot and moist, otherwise 5 to 10 % more than for light.
// REQ-EPHEMERIS-05
TEST(Refraction, OfRadioWavesGrowsWithMoisture)
{
    const Air tropics{.pressureHectopascal = 1010.0, .temperatureCelsius = 30.0, .relativeHumidity = 0.8};
    EXPECT_NEAR(arcMinutes(5_deg, Refraction::Radio, tropics), 13.5, 0.4);
    const double ordinary = arcMinutes(5_deg, Refraction::Radio) / arcMinutes(5_deg);
    EXPECT_GT(ordinary, 1.05);
    EXPECT_LT(ordinary, 1.10);
    const Air dry{.relativeHumidity = 0.0};
    EXPECT_NEAR(arcMinutes(5_deg, Refraction::Radio, dry) / arcMinutes(5_deg), 1.0, 0.03);
}

// REQ-EPHEMERIS-05
TEST(Refraction, AgreesWithBennettTheOtherWay)
{
    for (double seen = 0.0; seen <= 90.0; seen += 0.25) {
        const Angle from = Angle::fromDegrees(seen);
        const Angle back = airless({.azimuth = 0_deg, .elevation = from}, Refraction::Light).elevation;
        EXPECT_NEAR(60.0 * (from - back).degrees(), bennett(seen), seen < 1.0 ? 0.6 : 0.15) << seen;
    }
}

// REQ-EPHEMERIS-06: The conversion from true to apparent elevation and back is exact to 1e-9° everywhere, without a
// jump.
TEST(Refraction, ThereAndBackIsExact)
{
    const Air heavy{.pressureHectopascal = 1060.0, .temperatureCelsius = 35.0, .relativeHumidity = 1.0};
    for (const Refraction kind : {Refraction::None, Refraction::Light, Refraction::Radio}) {
        for (double degrees = -90.0; degrees <= 90.0; degrees += 0.1) {
            const SkyPointing direction{.azimuth = 271_deg, .elevation = Angle::fromDegrees(degrees)};
            const SkyPointing back = airless(apparent(direction, kind, heavy), kind, heavy);
            EXPECT_EQ(back.azimuth, direction.azimuth);
            EXPECT_NEAR(back.elevation.degrees(), degrees, 1e-9);
        }
    }
}

// A higher place appears higher. There is no jump where the refraction fades out below the horizon.
// REQ-EPHEMERIS-06
TEST(Refraction, NeverLeapsOrTurnsRound)
{
    const Angle step = Angle::fromDegrees(0.01);
    for (Angle trueElevation = -3_deg; trueElevation < 90_deg; trueElevation += step) {
        const Angle higher = refraction(trueElevation + step, Refraction::Radio);
        const Angle change = higher - refraction(trueElevation, Refraction::Radio);
        EXPECT_GT(step + change, 0_deg) << trueElevation.degrees();
        EXPECT_LT(abs(change), step) << trueElevation.degrees();
    }
    EXPECT_EQ(refraction(-2_deg, Refraction::Light), 0_deg);
    EXPECT_EQ(refraction(-45_deg, Refraction::Light), 0_deg);
}
