// SPDX-License-Identifier: GPL-3.0-or-later
// The permitted region, enforced below every source of motion.
#include "tests/core/motion/region_ride.h"

#include <gtest/gtest.h>

using namespace boresight;
using namespace boresight::region_ride;
using namespace std::chrono_literals;

// REQ-AXES-25 (MotionRegion.*): Limits, horizon and keep-outs apply to every motion from every source. Set-points never
// enter a forbidden area. A jog stops at the edge or slides along it. The mount brakes for an edge that is moved. From
// inside only the way out is open.
TEST(MotionRegion, GoesAroundAKeepOutAndArrives)
{
    Ride run(mount({.keepOuts = {mast()}}), at(290, 10));
    run.motion.goTo(at(340, 5));
    run.tick();
    EXPECT_EQ(run.motion.route(), (std::vector{at(300, 40), at(330, 40), at(340, 5)}));
    EXPECT_TRUE(run.untilRest());
    expectAt(run.motion, 340, 5);
    EXPECT_TRUE(run.motion.route().empty());
    EXPECT_LT(run.now - SteadyTime{}, 16s);
}

TEST(MotionRegion, AJogBrakesBeforeTheEdgeAndIsLetBack)
{
    Ride run(mount({.keepOuts = {mast()}}), at(290, 10));
    run.motion.run(rates(10, 0));
    EXPECT_TRUE(run.untilRest());
    expectAt(run.motion, 300, 10);
    EXPECT_TRUE(run.motion.held(Axis::Azimuth));
    EXPECT_FALSE(run.motion.held(Axis::Elevation));
    EXPECT_EQ(run.motion.obstacle().toStdString(), "the keep-out \"mast\"");
    run.motion.run(rates(-1, 0));
    run.ticks(100);
    EXPECT_FALSE(run.motion.held(Axis::Azimuth));
    EXPECT_LT(run.motion.place().azimuth, 299_deg);
}

TEST(MotionRegion, AJogSlidesAlongTheEdge)
{
    Ride run(mount({.keepOuts = {mast()}}), at(290, 10));
    run.motion.run(rates(5, 2));
    while (run.motion.place().azimuth < 335_deg && run.now < SteadyTime{} + 60s) {
        run.tick();
    }
    EXPECT_GT(run.motion.place().elevation, 40_deg);  // up along its side, then over it
    EXPECT_LT(run.now, SteadyTime{} + 30s);
}

TEST(MotionRegion, AJogIntoASlopeOfTheHorizonStopsOnIt)
{
    Ride run(mount({.horizon = {{0_deg, 0_deg}, {100_deg, 0_deg}, {120_deg, 40_deg}, {200_deg, 0_deg}}}), at(90, 20));
    run.motion.run(rates(6, 0));
    EXPECT_TRUE(run.untilRest());
    expectAt(run.motion, 110, 20);
    EXPECT_EQ(run.motion.obstacle().toStdString(), "the horizon");
}

// REQ-AXES-27: The set-points of a rotator that moves by itself wait while the way from its measured position to them
// is not free for every order of its axes. A rotator near its set-point has arrived.
TEST(MotionRegion, WaitsForARotatorThatLagsBehind)
{
    Capabilities can;
    can.axes.fill(AxisCapabilities{.step = 1_deg, .miss = 2_deg});
    const profile::Profile profile = mount({.keepOuts = {mast()}});
    Motion motion(profile, can);
    motion.start(Axis::Azimuth, 290_deg);
    motion.start(Axis::Elevation, 20_deg);
    motion.goTo(at(340, 20));
    SteadyTime now{};
    AxisPosition seen = at(290, 20);
    const auto ride = [&](int ticks, double elevationRate) {
        for (int tick = 0; tick < ticks; ++tick) {
            now += kMotionRegionTick;
            motion.setSeen(seen);
            motion.advance(now, kMotionRegionTick);
            const Angle up = Angle::fromDegrees(elevationRate * 0.02);
            seen.elevation = std::min(seen.elevation + up, std::max(motion.place().elevation, seen.elevation));
        }
    };
    ride(2000, 0.0);
    EXPECT_LE(motion.place().azimuth, 300_deg) << "the rotator stands in front of the mast";
    EXPECT_GE(motion.place().elevation, 40_deg);
    EXPECT_FALSE(motion.stray());
    EXPECT_TRUE(motion.held(Axis::Azimuth));
    EXPECT_EQ(motion.obstacle(), QStringLiteral("the keep-out \"mast\""));
    ride(2000, 1.0);
    EXPECT_GT(motion.place().azimuth, 330_deg);
    seen = at(340, 22);
    ride(2000, 0.0);
    EXPECT_EQ(motion.place(), at(340, 20)) << "it missed its place by 2°, and stands";
}

// REQ-AXES-28: A rotator that was pushed into a keep-out is taken over at its position, so that it can be moved out.
TEST(MotionRegion, ARotatorThatWasPushedIsTakenOverThere)
{
    Capabilities can;
    can.axes.fill(AxisCapabilities{.step = 1_deg, .miss = 2_deg});
    Motion motion(mount({.keepOuts = {mast()}}), can);
    motion.start(Axis::Azimuth, 298_deg);
    motion.start(Axis::Elevation, 20_deg);
    SteadyTime now{};
    const auto strayWithin = [&](int ticks) {
        for (int tick = 0; tick < ticks; ++tick) {
            now += kMotionRegionTick;
            motion.advance(now, kMotionRegionTick);
            if (motion.stray()) {
                return true;
            }
        }
        return false;
    };
    motion.setSeen(at(298, 20));
    EXPECT_FALSE(strayWithin(1000));
    motion.setSeen(at(304, 20));
    EXPECT_FALSE(strayWithin(350)) << "its driver may yet find that it does not go";
    EXPECT_TRUE(strayWithin(100));
    motion.start(Axis::Azimuth, 304_deg);
    motion.run(rates(-3, 0));
    for (int tick = 0; tick < 200; ++tick) {
        motion.setSeen(motion.place());
        EXPECT_FALSE(strayWithin(1));
    }
    EXPECT_LT(motion.place().azimuth, 300_deg);
}

TEST(MotionRegion, AForbiddenTargetIsReplacedByTheNearestPlace)
{
    Ride run(mount({.keepOuts = {mast()}}), at(200, 10));
    run.motion.goTo(at(302, 20));
    run.tick();
    EXPECT_TRUE(run.motion.limited());
    EXPECT_TRUE(run.untilRest());
    expectAt(run.motion, 300, 20);
    run.motion.goTo(at(200, 20));
    run.tick();
    EXPECT_FALSE(run.motion.limited());
}

TEST(MotionRegion, AStreamBehindAKeepOutWaitsAtItsSideThenGoesAroundAndRejoins)
{
    Ride run(mount({.keepOuts = {mast()}}), at(280, 20));
    double azimuth = 280;
    bool limited = false;
    for (int second = 0; second < 100; ++second, azimuth += 0.8) {
        run.motion.follow(at(azimuth, 20), run.now);
        run.motion.confirmStream(run.now);
        run.ticks(50);
        limited = limited || run.motion.limited();
    }
    EXPECT_TRUE(limited);
    EXPECT_FALSE(run.motion.limited());
    EXPECT_TRUE(run.motion.streaming(run.now));
    expectAt(run.motion, azimuth, 20, 0.2);
}

TEST(MotionRegion, SaysWhyThereIsNoWayAndStands)
{
    Ride run(mount({.keepOuts = {mast(90_deg)}}), at(290, 10));
    EXPECT_FALSE(run.motion.route(at(290, 10), at(340, 10)));
    run.motion.goTo(at(340, 10));
    EXPECT_TRUE(run.untilRest());
    expectAt(run.motion, 290, 10);
    EXPECT_EQ(run.motion.noWay().toStdString(),
              "There is no way from 290.0° 10.0° to 340.0° 10.0°. Between them is the keep-out \"mast\".");
}

TEST(MotionRegion, AnEdgeDrawnBeforeAMovingMountStopsIt)
{
    Ride run(mount({}), at(280, 10));
    run.motion.run(rates(10, 0));
    run.ticks(100);
    const Angle before = run.motion.place().azimuth;
    pointing::KeepOut drawn = mast();
    drawn.azimuthFrom = before + 1_deg;
    run.draw({.keepOuts = {drawn}});
    EXPECT_TRUE(run.untilRest());
    const AxisPosition inside = run.motion.place();
    EXPECT_LT(inside.azimuth, before + 6.5_deg);  // 10²/(2 × 10) and the filter
    EXPECT_FALSE(run.motion.region().permits(inside));
    EXPECT_TRUE(run.motion.held(Axis::Azimuth));
    run.motion.run(rates(5, 5));  // deeper, and away from the nearest edge
    run.ticks(100);
    EXPECT_EQ(run.motion.place(), inside);
    run.motion.run(rates(-5, 0));
    run.ticks(100);
    EXPECT_TRUE(run.motion.region().permits(run.motion.place()));
}

TEST(MotionRegion, AnEdgeDrawnFarAheadIsBrakedFor)
{
    Ride run(mount({}), at(260, 10));
    run.motion.goTo(at(400, 10));
    run.ticks(100);
    run.draw({.keepOuts = {mast(90_deg)}});
    EXPECT_TRUE(run.untilRest());
    EXPECT_TRUE(run.motion.region().permits(run.motion.place()));
    EXPECT_LT(run.motion.place().azimuth, 300.000001_deg);
}

TEST(MotionRegion, LowerLimitsOfMotionDoNotCarryItOverTheEdge)
{
    Ride run(mount({.keepOuts = {mast()}}), at(270, 10));
    run.motion.run(rates(10, 0));
    while (run.motion.place().azimuth < 293_deg) {
        run.tick();
    }
    profile::Profile gentle;
    gentle.azimuth.limits.acceleration = AngularAcceleration::fromDegrees(2);
    run.motion.setLimits(Axis::Azimuth, gentle.azimuth.limits);
    for (int i = 0; i < 1000; ++i) {
        run.now += kMotionRegionTick;
        // it may brake harder than the new limit: the region has priority
        run.motion.advance(run.now, kMotionRegionTick);
        ASSERT_TRUE(run.motion.region().permits(run.motion.place()));
    }
}

TEST(MotionRegion, WhileTheTurnIsNotKnownOnlyTheTravelCounts)
{
    Ride run(mount({.keepOuts = {mast()}}), at(290, 10));
    run.motion.enforceRegion(false);
    run.motion.run(rates(2, 0));
    for (int i = 0; i < 800; ++i) {
        run.now += kMotionRegionTick;
        run.motion.advance(run.now, kMotionRegionTick);
    }
    EXPECT_GT(run.motion.place().azimuth, 301_deg);
}

// Story: an axis that was pushed beyond its travel and jogged back and forth crept out again, because its set-point
// lags behind its motion.
TEST(MotionRegion, OutsideTheTravelItOnlyMovesBackInside)
{
    for (const double azimuth : {451.7, -90.0002}) {
        for (const double rate : {5.0, -5.0}) {
            Ride run(mount({}, {-90_deg, 450_deg}), at(azimuth, 30));
            const auto outside = [&run] {
                return std::max(run.motion.place().azimuth - 450_deg, -90_deg - run.motion.place().azimuth);
            };
            Angle last = outside();
            for (int i = 0; i < 200; ++i) {
                run.motion.run(rates(i / 15 % 2 == 0 ? rate : -rate, 3));
                run.now += kMotionRegionTick;
                run.motion.advance(run.now, kMotionRegionTick);
                EXPECT_LE(outside(), std::max(last, 0_deg) + Angle::fromDegrees(1e-9))
                    << azimuth << " " << rate << " " << i;
                last = outside();
            }
        }
    }
}
