// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/mount_model.h"

#include "core/base/numbers.h"
#include "tests/fakes/random_pointing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <random>
#include <sstream>
#include <vector>

using namespace boresight;
using namespace boresight::pointing;

namespace {

MountModel mount(TravelRange azimuth, TravelRange elevation = {0_deg, 90_deg})
{
    return {AxisGeometry{.travel = azimuth}, AxisGeometry{.travel = elevation}};
}

Resolved resolveDegrees(const MountModel& model, double azimuth, double elevation, double nowAzimuth)
{
    return model.resolve(SkyPointing{Angle::fromDegrees(azimuth), Angle::fromDegrees(elevation)},
                         AxisPosition{Angle::fromDegrees(nowAzimuth), 30_deg});
}

double azimuthFor(const MountModel& model, double azimuth, double nowAzimuth)
{
    return resolveDegrees(model, azimuth, 30.0, nowAzimuth).position.azimuth.degrees();
}

double skyDistance(const SkyPointing& a, const SkyPointing& b)
{
    const double cosine =
        std::sin(a.elevation.radians()) * std::sin(b.elevation.radians()) +
        std::cos(a.elevation.radians()) * std::cos(b.elevation.radians()) * std::cos((a.azimuth - b.azimuth).radians());
    return Angle::fromRadians(std::acos(std::min(1.0, std::max(-1.0, cosine)))).degrees();
}

}  // namespace

// REQ-POINTING-04: A direction is reached on the wrap inside the travel that is nearest to the present position, for
// travels wider and narrower than 360°.
TEST(Resolve, TakesTheTurnNearestToNow)
{
    const MountModel model = mount({-90_deg, 450_deg});
    EXPECT_NEAR(azimuthFor(model, 10, 350), 370, 1e-9);
    EXPECT_NEAR(azimuthFor(model, 350, 10), -10, 1e-9);
    EXPECT_NEAR(azimuthFor(model, 10, 20), 10, 1e-9);
    EXPECT_NEAR(azimuthFor(model, 100, 440), 100, 1e-9);  // 460° would be nearer but is beyond the end
    EXPECT_NEAR(azimuthFor(model, 260, -80), 260, 1e-9);  // as -100°
    EXPECT_NEAR(azimuthFor(model, 90, 400), 450, 1e-9);   // the end itself belongs to the travel
    EXPECT_NEAR(azimuthFor(model, 270, 0), -90, 1e-9);
    EXPECT_NEAR(azimuthFor(model, 1e6, 0), 1e6 - 2778 * 360, 1e-6);  // any finite azimuth is a valid direction
}

// REQ-POINTING-10: A wrap outside the operating limits is not used.
TEST(Resolve, TakesATurnInsideTheLimitsOfOperation)
{
    MountModel model = mount({-200_deg, 460_deg});
    EXPECT_NEAR(azimuthFor(model, 10, 350), 370, 1e-9);
    model.limitTo({-90_deg, 365_deg}, {5_deg, 80_deg});
    EXPECT_NEAR(azimuthFor(model, 10, 350), 10, 1e-9);  // the cable allows 370°, but the limits do not
    EXPECT_NEAR(azimuthFor(model, 4, 350), 364, 1e-9);
    const Resolved low = resolveDegrees(model, 100, 2, 100);
    EXPECT_TRUE(low.limited);
    EXPECT_NEAR(low.position.elevation.degrees(), 5, 1e-9);
    EXPECT_EQ(low.reason.toStdString(), "elevation 2.0° below limit 5.0°");
    model.limitTo({0_deg, 180_deg}, {0_deg, 90_deg});
    EXPECT_EQ(resolveDegrees(model, 200, 30, 100).reason.toStdString(),
              "azimuth 200.0° outside limits (axis 0.0°…180.0°)");
}

// REQ-POINTING-04
TEST(Resolve, OtherTravels)
{
    EXPECT_NEAR(azimuthFor(mount({-180_deg, 180_deg}), 190, 170), -170, 1e-9);
    EXPECT_NEAR(azimuthFor(mount({-180_deg, 180_deg}), 180, -170), -180, 1e-9);
    EXPECT_NEAR(azimuthFor(mount({-180_deg, 180_deg}), 180, 170), 180, 1e-9);
    EXPECT_NEAR(azimuthFor(mount({0_deg, 450_deg}), 350, 10), 350, 1e-9);
    EXPECT_NEAR(azimuthFor(mount({0_deg, 450_deg}), 80, 300), 440, 1e-9);
    EXPECT_NEAR(azimuthFor(mount({0_deg, 450_deg}), 95, 440), 95, 1e-9);
    EXPECT_NEAR(azimuthFor(mount({720_deg, 1080_deg}), 10, 1000), 730, 1e-9);
}

// A pass continues through north as long as the cable allows, in both directions and without a jump.
// REQ-POINTING-05: Going through north does not unwrap the cable as long as the travel allows to go on.
TEST(Resolve, APassThroughNorthNeverUnwinds)
{
    const MountModel model = mount({-90_deg, 450_deg});
    for (const double step : {0.1, -0.1}) {
        AxisPosition now{step > 0 ? 250_deg : 110_deg, 30_deg};
        for (int i = 0; i < 1900; ++i) {
            const Angle azimuth = (now.azimuth + Angle::fromDegrees(step)).wrapped360();
            const Resolved next = model.resolve(SkyPointing{azimuth, 30_deg}, now);
            ASSERT_FALSE(next.limited);
            ASSERT_NEAR((next.position.azimuth - now.azimuth).degrees(), step, 1e-9);
            now = next.position;
        }
        EXPECT_NEAR(now.azimuth.degrees(), step > 0 ? 440.0 : -80.0, 1e-6);
    }
}

// REQ-POINTING-04
TEST(Resolve, IsTheNearestTurnInsideTheTravel)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<double> angle(-400.0, 800.0);
    std::uniform_real_distribution<double> span(360.0, 900.0);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int i = 0; i < 20000; ++i) {
        const double low = angle(random) - 400.0;
        const double high = low + span(random);
        const double now = low + share(random) * (high - low);
        const double target = angle(random);
        const MountModel model = mount({Angle::fromDegrees(low), Angle::fromDegrees(high)});
        const Resolved resolved = resolveDegrees(model, target, 30.0, now);
        const double chosen = resolved.position.azimuth.degrees();
        ASSERT_FALSE(resolved.limited);
        ASSERT_GE(chosen, low - 1e-9);
        ASSERT_LE(chosen, high + 1e-9);
        double nearest = 1e9;
        for (double turn = target - 3600.0; turn <= target + 3600.0; turn += 360.0) {
            if (turn >= low && turn <= high) {
                nearest = std::min(nearest, std::abs(turn - now));
            }
        }
        const double missed = std::abs(std::remainder(chosen - target, 360.0));
        if (missed > 1e-9) {  // only the tolerance at the ends of the travel may cause an error
            ASSERT_LE(missed, 0.25 + 1e-9);
            ASSERT_TRUE(std::abs(chosen - low) < 1e-9 || std::abs(chosen - high) < 1e-9);
        } else {
            ASSERT_NEAR(std::abs(chosen - now), nearest, 1e-9);
        }
    }
}

// Story: on a 0…360° mount a target that jittered across north sent the antenna around by 360° with every point.
// REQ-POINTING-06: A jittering target does not make the mount change wraps or ends.
TEST(Resolve, NoiseAtAnEndOfTheTravelDoesNotFlap)
{
    const MountModel model = mount({0_deg, 360_deg});
    AxisPosition now{359.9_deg, 30_deg};
    for (const double azimuth : {0.1, 359.9, 0.2, 359.95, 0.0, 0.15}) {
        const Resolved resolved = model.resolve(SkyPointing{Angle::fromDegrees(azimuth), 30_deg}, now);
        EXPECT_GE(resolved.position.azimuth, 359.9_deg - 1e-9_deg);
        EXPECT_FALSE(resolved.limited);
        now = resolved.position;
    }
    // A target clearly beyond the end makes the mount go around. Then the same jitter has no effect.
    now = model.resolve(SkyPointing{0.3_deg, 30_deg}, now).position;
    EXPECT_NEAR(now.azimuth.degrees(), 0.3, 1e-9);
    for (const double azimuth : {0.1, 359.9, 0.2, 359.95}) {
        now = model.resolve(SkyPointing{Angle::fromDegrees(azimuth), 30_deg}, now).position;
        EXPECT_LE(now.azimuth.degrees(), 0.3);
    }
    // From a distant position the tolerance does not apply: the direction is reached exactly.
    EXPECT_NEAR(azimuthFor(model, 0.1, 300), 0.1, 1e-9);
}

// The chosen wrap is kept: `now` is then the target, so jitter around "equally far" cannot change the wrap.
// REQ-POINTING-06
TEST(Resolve, OppositeTargetDoesNotFlap)
{
    const MountModel model = mount({-90_deg, 450_deg});
    AxisPosition now{180_deg, 30_deg};
    now = model.resolve(SkyPointing{0.05_deg, 30_deg}, now).position;
    const Angle chosen = now.azimuth;
    for (const double azimuth : {359.95, 0.05, 359.9, 0.1}) {
        now = model.resolve(SkyPointing{Angle::fromDegrees(azimuth), 30_deg}, now).position;
        EXPECT_LT(abs(now.azimuth - chosen), 0.2_deg);
    }
}

// REQ-POINTING-08: A direction out of reach gives the permitted point nearest on the sky, and the reason in words.
TEST(Resolve, ElevationBeyondItsTravelIsLimitedWithTheReason)
{
    const MountModel model = mount({-90_deg, 450_deg}, {5_deg, 80_deg});
    const Resolved high = resolveDegrees(model, 100, 85, 90);
    EXPECT_TRUE(high.limited);
    EXPECT_EQ(high.reason.toStdString(), "elevation 85.0° above limit 80.0°");
    EXPECT_EQ(high.position.elevation, 80_deg);
    EXPECT_EQ(resolveDegrees(model, 100, 80.04, 90).reason.toStdString(), "elevation 80.04° above limit 80.00°");
    EXPECT_NEAR(high.position.azimuth.degrees(), 100, 1e-9);
    const Resolved low = resolveDegrees(model, 100, -90, 90);
    EXPECT_TRUE(low.limited);
    EXPECT_EQ(low.reason.toStdString(), "elevation -90.0° below limit 5.0°");
    EXPECT_EQ(low.position.elevation, 5_deg);
    EXPECT_FALSE(resolveDegrees(model, 100, 80, 90).limited);
}

// REQ-POINTING-07: A target above 90° goes over the top if the elevation travel allows it, otherwise to the equal
// direction below 90°.
TEST(Resolve, OverTheTop)
{
    const MountModel flips = mount({-90_deg, 450_deg}, {0_deg, 180_deg});
    const Resolved over = resolveDegrees(flips, 180.9, 137.68, 170);
    EXPECT_FALSE(over.limited);
    EXPECT_NEAR(over.position.azimuth.degrees(), 180.9, 1e-9);
    EXPECT_NEAR(over.position.elevation.degrees(), 137.68, 1e-9);

    const MountModel upright = mount({-90_deg, 450_deg});
    const Resolved equal = resolveDegrees(upright, 180.9, 137.68, 340);
    EXPECT_FALSE(equal.limited);
    EXPECT_NEAR(equal.position.azimuth.degrees(), 360.9, 1e-9);
    EXPECT_NEAR(equal.position.elevation.degrees(), 42.32, 1e-9);

    const Resolved outOfReach = resolveDegrees(mount({0_deg, 90_deg}, {0_deg, 180_deg}), 200, 150, 10);
    EXPECT_FALSE(outOfReach.limited) << "as 20°, 30° it lies in the travel";
    EXPECT_NEAR(outOfReach.position.azimuth.degrees(), 20, 1e-9);
    EXPECT_NEAR(outOfReach.position.elevation.degrees(), 30, 1e-9);
}

// REQ-POINTING-08
TEST(Resolve, InAGapTheNearerEndIsTaken)
{
    const MountModel model = mount({-90_deg, 90_deg});
    const Resolved right = resolveDegrees(model, 100, 20, 0);
    EXPECT_TRUE(right.limited);
    EXPECT_EQ(right.reason.toStdString(), "azimuth 100.0° outside travel (axis -90.0°…90.0°)");
    EXPECT_NEAR(right.position.azimuth.degrees(), 90, 1e-9);
    EXPECT_NEAR(resolveDegrees(model, 260, 20, 80).position.azimuth.degrees(), -90, 1e-9);
    const Resolved both = resolveDegrees(model, 180, -5, 80);
    EXPECT_EQ(both.reason.toStdString(),
              "azimuth 180.0° outside travel (axis -90.0°…90.0°), elevation -5.0° below limit 0.0°");
}

// REQ-POINTING-06
TEST(Resolve, InTheMiddleOfAGapItDoesNotFlap)
{
    const MountModel model = mount({-90_deg, 90_deg});
    AxisPosition now = resolveDegrees(model, 179.5, 20, 80).position;
    for (const double azimuth : {180.2, 179.8, 180.4, 179.9}) {
        now = model.resolve(SkyPointing{Angle::fromDegrees(azimuth), 20_deg}, now).position;
        EXPECT_EQ(now.azimuth, 90_deg);
    }
    EXPECT_EQ(model.resolve(SkyPointing{200_deg, 20_deg}, now).position.azimuth, -90_deg);
}

// Every result is inside the travel. No permitted point is nearer on the sky by more than 1°, the preference for the
// end where the mount already is.
// REQ-POINTING-08
TEST(Resolve, IsThePermittedPointNearestOnTheSky)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int i = 0; i < 3000; ++i) {
        const double low = -200.0 + 200.0 * unit(random);
        const double high = low + 10.0 + 340.0 * unit(random);
        const double bottom = 30.0 * unit(random);
        const double top = bottom + 10.0 + (90.0 - bottom - 10.0) * unit(random);
        const MountModel model = mount({Angle::fromDegrees(low), Angle::fromDegrees(high)},
                                       {Angle::fromDegrees(bottom), Angle::fromDegrees(top)});
        const SkyPointing wanted{Angle::fromDegrees(360.0 * unit(random)), Angle::fromDegrees(90.0 * unit(random))};
        const AxisPosition now{Angle::fromDegrees(low + (high - low) * unit(random)), model.elevation().travel.min};
        const Resolved resolved = model.resolve(wanted, now);
        ASSERT_TRUE(model.azimuth().travel.contains(resolved.position.azimuth));
        ASSERT_TRUE(model.elevation().travel.contains(resolved.position.elevation));
        ASSERT_EQ(resolved.limited, !resolved.reason.isEmpty());
        const double reached = skyDistance(model.toSky(resolved.position), wanted);
        if (!resolved.limited) {
            ASSERT_LE(reached, 0.25 + 1e-6);
            continue;
        }
        for (int k = 0; k < 100; ++k) {
            const SkyPointing other{Angle::fromDegrees(low + (high - low) * unit(random)),
                                    Angle::fromDegrees(bottom + (top - bottom) * unit(random))};
            ASSERT_LE(reached, skyDistance(other, wanted) + 1.0 + 1e-6);
        }
    }
}

// REQ-POINTING-09: Axis angles keep their wrap.
TEST(Resolve, MechanicalAnglesAreTakenAsTheyAre)
{
    const MountModel model = mount({-180_deg, 450_deg});
    EXPECT_EQ(model.resolve(AxisPosition{400_deg, 20_deg}).position, (AxisPosition{400_deg, 20_deg}));
    EXPECT_FALSE(model.resolve(AxisPosition{450_deg, 90_deg}).limited);
    const Resolved resolved = model.resolve(AxisPosition{-190_deg, 95_deg});
    EXPECT_TRUE(resolved.limited);
    EXPECT_EQ(resolved.position, (AxisPosition{-180_deg, 90_deg}));
    EXPECT_EQ(resolved.reason.toStdString(),
              "azimuth axis -190.0° below limit -180.0°, elevation 95.0° above limit 90.0°");
}

TEST(ToSky, FoldsTurnsAndOverTheTop)
{
    const SkyPointing turned = mount({-90_deg, 450_deg}).toSky({370_deg, 30_deg});
    EXPECT_NEAR(turned.azimuth.degrees(), 10, 1e-9);
    EXPECT_NEAR(turned.elevation.degrees(), 30, 1e-9);
    const SkyPointing flipped = mount({-90_deg, 450_deg}).toSky({200_deg, 150_deg});
    EXPECT_NEAR(flipped.azimuth.degrees(), 20, 1e-9);
    EXPECT_NEAR(flipped.elevation.degrees(), 30, 1e-9);
}

// REQ-POINTING-03
TEST(ToSky, IsTheInverseOfResolve)
{
    std::mt19937 random(4);
    std::uniform_real_distribution<double> azimuth(0.0, 360.0);
    std::uniform_real_distribution<double> elevation(0.0, 90.0);
    const MountModel model = mount({-90_deg, 450_deg});
    AxisPosition now{};
    for (int i = 0; i < 10000; ++i) {
        const SkyPointing wanted{Angle::fromDegrees(azimuth(random)), Angle::fromDegrees(elevation(random))};
        now = model.resolve(wanted, now).position;
        const SkyPointing reached = model.toSky(now);
        ASSERT_NEAR((reached.azimuth - wanted.azimuth).wrapped180().degrees(), 0.0, 1e-9);
        ASSERT_NEAR(reached.elevation.degrees(), wanted.elevation.degrees(), 1e-9);
    }
}

// wrap_cases.csv has whole passes, with the start and the end of a path that fits the travel. From this start, the
// wraps that are chosen point by point must lead to this end without going around.
// REQ-POINTING-05
TEST(Resolve, FollowsPlannedPassesToTheirEnd)
{
    std::ifstream file(BORESIGHT_TEST_DATA "/wrap_cases.csv");
    std::string line;
    int passes = 0;
    while (std::getline(file, line)) {
        std::vector<std::string> field;
        std::istringstream fields(line);
        for (std::string text; std::getline(fields, text, ',');) {
            field.push_back(text);
        }
        if (field.size() < 13 || field[10] != "direct") {
            continue;
        }
        const double start = *parseFinite(field[11]);
        const double end = *parseFinite(field[12]);
        const MountModel model =
            mount({Angle::fromDegrees(*parseFinite(field[4])), Angle::fromDegrees(*parseFinite(field[5]))});
        AxisPosition now{Angle::fromDegrees(start), 30_deg};
        for (int i = 0; i <= 1000; ++i) {
            const Angle azimuth = Angle::fromDegrees(start + (end - start) * i / 1000.0).wrapped360();
            const Resolved next = model.resolve(SkyPointing{azimuth, 30_deg}, now);
            ASSERT_FALSE(next.limited) << line;
            ASSERT_LT(abs(next.position.azimuth - now.azimuth), 1_deg) << line;
            now = next.position;
        }
        EXPECT_NEAR(now.azimuth.degrees(), end, 1e-6) << line;
        ++passes;
    }
    EXPECT_GT(passes, 40);
}

// The mount of the original report and worse ones: for every true target direction the beam points there.
// REQ-POINTING-22: Directions are true, and positions are axis angles. With any model the beam points where it was
// asked to. The cable decides the wrap.
TEST(Resolve, WithAPointingModelTheBeamLooksWhereItWasAsked)
{
    std::mt19937 random(5);
    fakes::RandomPointing make(random);
    AxisPosition now{};
    for (int i = 0; i < 20000; ++i) {
        MountModel model = mount({-200_deg, 460_deg}, {-20_deg, 110_deg});
        model.setPointing(PointingModel(make.terms()));
        const SkyPointing wanted{make.degrees(0, 360), make.degrees(0, 83)};
        const Resolved resolved = model.resolve(wanted, now);
        ASSERT_FALSE(resolved.limited) << resolved.reason.toStdString();
        now = resolved.position;
        ASSERT_NEAR(fakes::separation(model.toSky(now), wanted), 0.0, 1e-9);
    }
}

// REQ-POINTING-22
TEST(Resolve, WithAPointingModelTheTurnIsChosenByTheCable)
{
    MountModel model = mount({-90_deg, 450_deg});
    model.setPointing(PointingModel({.azimuthOffset = 37.4_deg}));
    EXPECT_NEAR(azimuthFor(model, 10, 350), 332.6, 1e-9);
    EXPECT_NEAR(azimuthFor(model, 50, 350), 372.6, 1e-9);
    EXPECT_NEAR(azimuthFor(model, 50, 20), 12.6, 1e-9);
    const Resolved low = resolveDegrees(model, 100, -2, 100);
    EXPECT_EQ(low.reason.toStdString(), "elevation -2.0° below limit 0.0° (mechanical angles)");
}

// REQ-POINTING-20
TEST(Resolve, TheHoleAtTheZenithIsToleratedOrTold)
{
    MountModel model = mount({-90_deg, 450_deg});
    model.setPointing(PointingModel({.collimation = 0.3_deg}));
    EXPECT_FALSE(resolveDegrees(model, 0, 90, 0).limited);
    model.setPointing(PointingModel({.collimation = 1_deg}));
    const Resolved zenith = resolveDegrees(model, 0, 90, 0);
    EXPECT_TRUE(zenith.limited);
    EXPECT_EQ(zenith.reason.toStdString(), "the beam misses the zenith by 1.0°");
    EXPECT_NEAR(zenith.position.elevation.degrees(), 90.0, 1e-9);
}
