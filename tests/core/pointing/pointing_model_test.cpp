// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/pointing_model.h"

#include "tests/core/pointing/at.h"
#include "tests/fakes/random_pointing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace boresight;
using namespace boresight::pointing;
using boresight::fakes::RandomPointing;
using boresight::fakes::separation;

namespace {

// Far below the resolution of any encoder, and a hundred times the rounding error of a double.
constexpr double kExact = 1e-9;  // °

void expectSky(const PointingTerms& terms, const AxisPosition& axes, double azimuth, double elevation, double tolerance)
{
    const SkyPointing sky = PointingModel(terms).toSky(axes);
    EXPECT_NEAR(sky.azimuth.degrees(), azimuth, tolerance);
    EXPECT_NEAR(sky.elevation.degrees(), elevation, tolerance);
}

}  // namespace

// REQ-POINTING-17: Without terms the axis angles equal the true direction, to the last bit.
TEST(PointingModel, WithoutTermsEveryBitIsPassedThrough)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> any(-800.0, 800.0);
    const PointingModel model;
    EXPECT_TRUE(model.isIdentity());
    EXPECT_EQ(model, PointingModel(PointingTerms{}));
    for (int i = 0; i < 1000; ++i) {
        const AxisPosition axes = at(any(random), any(random));
        const SkyPointing sky = model.toSky(axes);
        EXPECT_EQ(sky, (SkyPointing{axes.azimuth, axes.elevation}));
        EXPECT_EQ(model.toAxes(sky).axes, axes);
        EXPECT_TRUE(model.toAxes(sky).exact());
    }
}

// Each term alone, a hundredth of a degree, at an azimuth of 30° or 90° and an elevation of 60°: sin 30° = cos 60° =
// 1/2, tan 60° = 1.7320508, 1 / cos 60° = 2. The rest is of second order, here 1e-5°.
// REQ-POINTING-18: Each term has the effect given in textbooks.
TEST(PointingModel, SmallTermsAreThoseOfTheTextbook)
{
    constexpr Angle k = 0.01_deg;
    constexpr double kSecondOrder = 1e-5;
    expectSky({.azimuthOffset = k}, at(30, 60), 30.01, 60.0, kExact);
    expectSky({.elevationOffset = k}, at(30, 60), 30.0, 60.01, kExact);
    expectSky({.tiltNorth = k}, at(30, 60), 30.0 - 0.00866025, 60.0 - 0.00866025, kSecondOrder);
    expectSky({.tiltNorth = k}, at(90, 60), 90.0 - 0.01732051, 60.0, kSecondOrder);
    expectSky({.tiltEast = k}, at(30, 60), 30.0 + 0.015, 60.0 - 0.005, kSecondOrder);
    expectSky({.tiltEast = k}, at(90, 60), 90.0, 60.0 - 0.01, kSecondOrder);
    expectSky({.collimation = k}, at(30, 60), 30.02, 60.0, kSecondOrder);
    expectSky({.nonPerpendicularity = k}, at(30, 60), 30.01732051, 60.0, kSecondOrder);
    expectSky({.elevationSag = k}, at(30, 60), 30.0, 59.995, kSecondOrder);
}

// The mount of the original report looks east at 45° elevation, and the parts are added by hand. A tilt of 0.6° to the
// north takes 0.6° × tan 45° from the azimuth, and a collimation of 0.3° adds 0.3° / cos 45° = 0.42426°. The true
// azimuth is 62.6° + 37.4° = 100°. There the lean to the north takes 0.6° × cos 100° = -0.10419° from the elevation,
// and only 0.6° × sin 100° = 0.59088° from the azimuth.
// REQ-POINTING-18
TEST(PointingModel, TheMountOfTheScenario)
{
    const PointingTerms terms{.azimuthOffset = 37.4_deg, .tiltNorth = 0.6_deg, .collimation = 0.3_deg};
    expectSky(terms, at(62.6, 45), 100.0 - 0.59088 + 0.42426, 45.0 + 0.10419, 0.01);
    EXPECT_NEAR(PointingModel(terms).skew().degrees(), 0.9, kExact);
}

// The mast leans 1° to the east. A beam raised to 90° points 1° past the zenith to the east.
// REQ-POINTING-18
TEST(PointingModel, ALeaningMastLooksPastTheZenith)
{
    const PointingModel model({.tiltEast = 1_deg});
    for (const double azimuth : {0.0, 77.0, 270.0}) {
        EXPECT_NEAR(separation(model.toSky(at(azimuth, 90)), {90_deg, 89_deg}), 0.0, kExact);
    }
    const Aim zenith = model.toAxes({0_deg, 90_deg});
    EXPECT_NEAR(zenith.axes.azimuth.degrees(), -90.0, kExact);  // away from the lean
    EXPECT_NEAR(zenith.axes.elevation.degrees(), 89.0, kExact);
}

// REQ-POINTING-19: Sky to axes and axes to sky are inverse to 1e-9°, also at the zenith and over the top. They keep the
// wrap and the side of the zenith.
TEST(PointingModel, FromTheSkyToTheAxesAndBackIsExact)
{
    std::mt19937 random(20261121);
    RandomPointing make(random);
    int beyondReach = 0;
    for (int i = 0; i < 100000; ++i) {
        const PointingModel model(make.terms());
        const SkyPointing wanted = make.direction();
        const Aim aim = model.toAxes(wanted);
        const double error = separation(model.toSky(aim.axes), wanted);
        EXPECT_NEAR(error, aim.miss.degrees(), kExact) << wanted.elevation.degrees();
        beyondReach += aim.exact() ? 0 : 1;
    }
    EXPECT_GT(beyondReach, 1000);  // directions at the very zenith
    EXPECT_LT(beyondReach, 50000);
}

// Axis angles to the sky and back, including wraps and the side of the zenith. If a collimation keeps the beam off the
// zenith, the elevation hardly moves the beam at 90°. There a direction in 64 bits does not determine the last digits
// of the axis angles.
// REQ-POINTING-19
TEST(PointingModel, FromTheAxesToTheSkyAndBackIsExact)
{
    std::mt19937 random(7);
    RandomPointing make(random);
    for (int i = 0; i < 100000; ++i) {
        const PointingModel model(make.terms());
        const AxisPosition place = make.place();
        const SkyPointing sky = model.toSky(place);
        const Aim back = model.toAxes(sky);
        const double beyondTop = (place.elevation + model.terms().elevationOffset).degrees() - 90.0;
        if (std::abs(beyondTop) > 0.01) {
            EXPECT_EQ(sky.elevation > 90_deg, beyondTop > 0.0);
            EXPECT_NEAR(back.axes.azimuth.degrees(), place.azimuth.degrees(), kExact) << place.elevation.degrees();
            EXPECT_NEAR(back.axes.elevation.degrees(), place.elevation.degrees(), kExact);
        }
        EXPECT_NEAR(separation(model.toSky(back.axes), sky), 0.0, kExact) << place.elevation.degrees();
        EXPECT_LT(back.miss.degrees(), kExact);
    }
}

// REQ-POINTING-20: A direction that the axes cannot reach is missed by as little as possible, and the error is
// reported.
TEST(PointingModel, ADirectionInTheHoleIsMissedByWhatIsSaid)
{
    const PointingModel model({.azimuthOffset = 37.4_deg, .collimation = 2_deg, .nonPerpendicularity = 0.5_deg});
    const Aim zenith = model.toAxes({0_deg, 90_deg});
    EXPECT_NEAR(zenith.miss.degrees(), 2.5, kExact);
    EXPECT_NEAR(zenith.axes.elevation.degrees(), 90.0, kExact);
    const Aim inside = model.toAxes({123_deg, 88_deg});
    EXPECT_NEAR(inside.miss.degrees(), 0.5, kExact);
    const SkyPointing reached = model.toSky(inside.axes);
    // the nearest place on the edge of the unreachable area
    EXPECT_NEAR(reached.azimuth.wrapped360().degrees(), 123.0, 1e-6);
    EXPECT_NEAR(reached.elevation.degrees(), 87.5, kExact);
    EXPECT_TRUE(model.toAxes({123_deg, 87.4_deg}).exact());
}

// REQ-POINTING-19
TEST(PointingModel, TheTurnGoesOnWithTheAxes)
{
    const PointingModel model({.azimuthOffset = 37.4_deg, .tiltNorth = 0.6_deg});
    EXPECT_NEAR(model.toSky(at(370, 0)).azimuth.degrees(), 407.4, 0.01);
    EXPECT_NEAR(model.toSky(at(10, 0)).azimuth.degrees(), 47.4, 0.01);
    EXPECT_NEAR(model.toAxes({407.4_deg, 0_deg}).axes.azimuth.degrees(), 370, 0.01);
    EXPECT_NEAR(model.toSky(at(370, 150)).azimuth.degrees(), 407.4, 0.5);  // over the top
    EXPECT_NEAR(model.toSky(at(370, 150)).elevation.degrees(), 150, 0.7);
    const PointingModel nearlyATurn({.azimuthOffset = 350_deg});
    EXPECT_NEAR(nearlyATurn.toSky(at(100, 20)).azimuth.degrees(), 90, kExact);
}

// The mast leans 1° to the east. Half a degree from the zenith of the mount, away from the lean, the beam points 180°
// away from its axis. Then two wraps of the axis are equally near.
TEST(PointingModel, HalfATurnBetweenAxisAndBeamKeepsTheTurn)
{
    for (const double elevation : {89.5, 90.5}) {
        const PointingModel model({.tiltEast = 1_deg});
        for (const double azimuth : {-450.0, -90.0, 270.0, 630.0}) {
            const AxisPosition axes = at(azimuth, elevation);
            const AxisPosition back = model.toAxes(model.toSky(axes)).axes;
            EXPECT_NEAR(back.azimuth.degrees(), azimuth, kExact) << elevation;
            EXPECT_NEAR(back.elevation.degrees(), elevation, kExact);
        }
    }
}
