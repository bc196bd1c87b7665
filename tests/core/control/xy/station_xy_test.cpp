// SPDX-License-Identifier: GPL-3.0-or-later
// A mount with the axes X and Y. Sources, clients and the status speak of directions, and the drives get X and Y.
#include "core/clients/station_rotator.h"
#include "core/units/angle_between.h"
#include "tests/core/control/station_rig.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

const rotctld::Client kTracker{.id = 1, .address = "127.0.0.1:50000"};

profile::Profile xyProfile()
{
    profile::Profile profile;
    profile.pointing.geometry = {.kind = pointing::Geometry::XY};
    profile.azimuth.geometry.travel = {-90_deg, 90_deg};
    profile.elevation.geometry.travel = {-90_deg, 90_deg};
    return profile;
}

// A satellite on a straight line past the station, in km: `north` and `east` at its nearest, then along `heading`.
struct Flyby
{
    double north = 0.0;
    double east = 0.0;
    double height = 500.0;
    double heading = 0.0;  // radians
    double speed = 7.6;    // km/s

    [[nodiscard]] SkyPointing at(double seconds) const
    {
        const double n = north + speed * seconds * std::cos(heading);
        const double e = east + speed * seconds * std::sin(heading);
        return {.azimuth = Angle::fromRadians(std::atan2(e, n)).wrapped360(),
                .elevation = Angle::fromRadians(std::atan2(height, std::hypot(n, e)))};
    }
};

struct XYRig : StationRig
{
    explicit XYRig(const profile::Profile& settings = xyProfile()) : StationRig(settings) { run(Seconds(0.2)); }

    Result<QString> pointTo(const SkyPointing& direction)
    {
        return rotator.pointTo(kTracker, {.azimuth = direction.azimuth, .elevation = direction.elevation});
    }
    void expectAxes(double x, double y, double tolerance = 0.01)
    {
        EXPECT_NEAR(azimuthDegrees(), x, tolerance);
        EXPECT_NEAR(elevationDegrees(), y, tolerance);
    }

    struct Worst
    {
        double onSky = 0.0;    // °, between beam and target
        double inX = 0.0;      // °, as the status shows it
        double rateOfX = 0.0;  // °/s
    };
    // Follows the pass as a program does that sends a target every half second.
    Worst follow(const Flyby& pass, double from, double to)
    {
        EXPECT_TRUE(pointTo(pass.at(from)));
        settle();
        Worst worst;
        for (double at = from; at < to; at += 0.5) {
            EXPECT_TRUE(pointTo(pass.at(at))) << at;
            const double before = azimuthDegrees();
            run(Seconds(0.5));
            const StationStatus status = control.status();
            worst.rateOfX = std::max(worst.rateOfX, std::abs(azimuthDegrees() - before) / 0.5);
            worst.onSky = std::max(worst.onSky, angleBetween(*status.actual, pass.at(at + 0.5)).degrees());
            worst.inX = std::max(worst.inX, std::abs((*status.azimuth.target - *status.azimuth.actual).degrees()));
        }
        return worst;
    }

    StationRotator rotator{control, inForce, log, clock};
};

}  // namespace

// REQ-CONTROL-1751: On an X/Y mount a direction of a client or of the operator becomes angles of X and Y. The reported
// position is the direction of the beam. The status has both.
TEST(StationXY, ATargetOfAClientIsADirection)
{
    XYRig rig;
    ASSERT_TRUE(rig.pointTo({45_deg, 45_deg}));
    rig.settle();
    rig.expectAxes(35.264, 30.0);
    const auto position = rig.rotator.position(kTracker);
    ASSERT_TRUE(position);
    EXPECT_NEAR(position->azimuth.degrees(), 45.0, 0.01);
    EXPECT_NEAR(position->elevation.degrees(), 45.0, 0.01);
    const StationStatus status = rig.control.status();
    EXPECT_NEAR(status.azimuth.beam.actual->degrees(), 45.0, 0.01);
    EXPECT_NEAR(status.elevation.beam.actual->degrees(), 45.0, 0.01);
    EXPECT_NEAR(status.azimuth.actual->degrees(), 35.264, 0.01);
    EXPECT_NEAR(angleBetween(*status.actual, {45_deg, 45_deg}).degrees(), 0.0, 0.01);
}

// REQ-CONTROL-1751
TEST(StationXY, TheXAxisMayLieEastWest)
{
    profile::Profile profile = xyProfile();
    profile.pointing.geometry.xAxis = 90_deg;
    XYRig rig(profile);
    ASSERT_TRUE(rig.pointTo({180_deg, 30_deg}));
    rig.settle();
    rig.expectAxes(60.0, 0.0);
}

// REQ-CONTROL-1751
TEST(StationXY, AClientIsToldEveryDirectionAboveTheHorizon)
{
    XYRig rig;
    const rotctld::Limits limits = rig.rotator.limits();
    EXPECT_EQ(limits.minAzimuth, 0_deg);
    EXPECT_EQ(limits.maxAzimuth, 360_deg);
    EXPECT_NEAR(limits.minElevation.degrees(), 0.0, 1e-9);
    EXPECT_NEAR(limits.maxElevation.degrees(), 90.0, 1e-9);
}

// REQ-CONTROL-1752: The operator goes to directions and parks at angles of X and Y. A jog turns one axis. With one
// angle of a direction the other angle of the beam stays.
TEST(StationXY, TheOperatorGoesJogsAndParks)
{
    profile::Profile profile = xyProfile();
    profile.park = {-20_deg, 10_deg};
    XYRig rig(profile);
    ASSERT_TRUE(rig.point(225, 45, kOperator));
    rig.settle();
    rig.expectAxes(-35.264, -30.0);

    ASSERT_TRUE(rig.ask(request::PointAxis{.axis = Axis::Azimuth, .angle = 45_deg}));
    rig.settle();
    rig.expectAxes(35.264, 30.0);
    ASSERT_TRUE(rig.ask(request::PointAxis{.axis = Axis::Elevation, .angle = 90_deg}));
    rig.settle();
    rig.expectAxes(0.0, 0.0);

    for (int i = 0; i < 20; ++i) {
        ASSERT_TRUE(rig.ask(request::Jog{{.azimuth = 2_deg_s}}));
        rig.run(Seconds(0.1));
    }
    ASSERT_TRUE(rig.ask(request::Jog{{}}));
    rig.settle();
    EXPECT_GT(rig.azimuthDegrees(), 2.0);
    EXPECT_NEAR(rig.elevationDegrees(), 0.0, 0.01);

    ASSERT_TRUE(rig.ask(request::Park{}));
    rig.settle();
    rig.expectAxes(-20.0, 10.0);
    EXPECT_EQ(rig.state(), StationState::Parked);
}

// REQ-CONTROL-1753: What an X/Y mount does not have is refused with the reason: a cable to unwrap, an elevation axis to
// lower, a way over the top.
TEST(StationXY, WhatItDoesNotHaveIsRefused)
{
    XYRig rig;
    const Permissions may = rig.control.status().permissions;
    EXPECT_EQ(may.reason(Action::Unwind).toStdString(), "An X/Y mount has no cable to unwrap.");
    EXPECT_EQ(may.reason(Action::Horizon).toStdString(),
              "An X/Y mount has no elevation axis to lower. Go to a direction instead.");
    EXPECT_FALSE(rig.ask(request::Unwind{}));
    EXPECT_FALSE(rig.ask(request::Horizon{}));
    EXPECT_FALSE(rig.point(45, 120, kOperator));
    EXPECT_FALSE(rig.moving());
}

// REQ-CONTROL-1754: The limits of X and Y, the horizon and the keep-outs hold for every source on an X/Y mount.
TEST(StationXY, LimitsHoldForEverySource)
{
    XYRig rig;
    pointing::Region region;
    region.azimuth = {-70_deg, 70_deg};
    region.horizon = {{.azimuth = 0_deg, .elevation = 10_deg}};
    region.keepOuts = {
        {.name = "mast", .azimuthFrom = 170_deg, .azimuthTo = 190_deg, .elevationMin = 0_deg, .elevationMax = 50_deg}};
    rig.draw(region);

    const Result<> east = rig.point(90, 15, kOperator);
    ASSERT_FALSE(east);
    EXPECT_EQ(textOf(east.error()), "X axis 75.0° above limit 70.0°");
    const Result<> mast = rig.point(180, 30, kOperator);
    ASSERT_FALSE(mast);
    EXPECT_EQ(textOf(mast.error()), "180.0° / 30.0° lies in keep-out \"mast\". Nearest allowed: 190.2° / 30.0°.");
    EXPECT_FALSE(rig.point(0, 5, kOperator));
    EXPECT_FALSE(rig.moving());

    // A client is led to the nearest permitted place.
    ASSERT_TRUE(rig.pointTo({90_deg, 15_deg}));
    rig.settle();
    rig.expectAxes(70.0, 0.0, 0.05);
    ASSERT_TRUE(rig.pointTo({180_deg, 30_deg}));
    rig.settle();
    const SkyPointing beam = *rig.control.status().actual;
    EXPECT_TRUE(beam.elevation > 50_deg || abs((beam.azimuth - 180_deg).wrapped180()) > 10_deg);
    EXPECT_LT(angleBetween(beam, {180_deg, 30_deg}).degrees(), 13.0);

    // A jog ends at the horizon: at X 0° and 10° of elevation Y is at most 80°.
    ASSERT_TRUE(rig.point(0, 60, kOperator));
    rig.settle();
    for (int i = 0; i < 300; ++i) {
        ASSERT_TRUE(rig.ask(request::Jog{{.elevation = 5_deg_s}}) || rig.elevationDegrees() > 78.0);
        rig.run(Seconds(0.1));
    }
    EXPECT_LE(rig.elevationDegrees(), 80.01);
    EXPECT_GT(rig.elevationDegrees(), 78.0);
}

// REQ-CONTROL-1755: An X/Y mount follows a pass through the zenith without a detour: both axes stay slow.
TEST(StationXY, APassThroughTheZenithHasNoKeyhole)
{
    for (const double heading : {1.5707963, 0.6}) {
        XYRig rig;
        const XYRig::Worst worst = rig.follow({.heading = heading}, -150.0, 150.0);
        EXPECT_LT(worst.onSky, 0.1) << heading;
        EXPECT_LT(worst.rateOfX, 1.5) << heading;
    }
}

// A pass low in the north crosses the keyhole: X has to turn from west to east at the top of the pass, at 4.6 °/s. This
// axis turns at 2 °/s at most, so X is 40° behind. In the keyhole that is 4.6° on the sky.
// REQ-CONTROL-1756: In the keyhole the speed of X is limited to that of its axis, and the status shows the error of X.
TEST(StationXY, ALowPassThroughTheKeyholeIsLimitedByTheAxis)
{
    const Flyby low{.north = 8000.0, .heading = 1.5707963, .speed = 40.0};
    profile::Profile profile = xyProfile();
    profile.azimuth.limits.speed = 2_deg_s;
    XYRig rig(profile);
    const XYRig::Worst worst = rig.follow(low, -100.0, 100.0);
    EXPECT_LE(worst.rateOfX, 2.02);
    EXPECT_GT(worst.inX, 30.0);
    EXPECT_LT(worst.onSky, 6.0);
    XYRig quick;
    const XYRig::Worst better = quick.follow(low, -100.0, 100.0);
    EXPECT_LT(better.onSky, 0.5);
    EXPECT_GT(better.rateOfX, 4.0);
}

}  // namespace boresight
