// SPDX-License-Identifier: GPL-3.0-or-later
// The normal motions of a healthy mount in ordinary weather cause no finding.
#include "tests/core/supervision/supervised_mount.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace boresight::supervision {
namespace {

using sim::FaultKind;

// REQ-SUPERVISION-11 (NoFalseFinding.*): A healthy mount causes no finding: standing still, slews at full speed, jogs
// and reversals, sidereal tracking, steps of 0.1°, gusts of 150 % and 300 % of the tracking torque, one lost reply in a
// hundred, a whole pass.
TEST(NoFalseFinding, StandingStillForTwentyMinutes)
{
    SupervisedMount mount;
    mount.run(Seconds(600.0));
    mount.engage();
    mount.run(Seconds(600.0));
    EXPECT_EQ(mount.report(), "");
}

TEST(NoFalseFinding, SlewsAtFullSpeedOverTheWholeTravel)
{
    SupervisedMount mount;
    mount.engage();
    for (const double azimuth : {450.0, -90.0, 200.0}) {
        mount.goTo(Axis::Azimuth, Angle::fromDegrees(azimuth));
        for (const double elevation : {90.0, 0.0, 45.0, 10.0}) {
            mount.goTo(Axis::Elevation, Angle::fromDegrees(elevation));
            mount.run(Seconds(15.0));
        }
    }
    EXPECT_EQ(mount.report(), "");
    EXPECT_NEAR(mount.seen(Axis::Azimuth).actual.degrees(), 200.0, 0.1);
}

TEST(NoFalseFinding, JogsAndReversalsAtAnyRate)
{
    SupervisedMount mount(sim::commissionedPair({.azimuth = 180_deg, .elevation = 45_deg}));
    mount.engage();
    for (const double rate : {0.2, 2.0, 6.0, 10.0}) {
        for (const double hold : {0.1, 0.3, 0.7, 1.5}) {
            for (const double direction : {1.0, -1.0, -1.0, 1.0, 0.0}) {
                mount.turn(Axis::Azimuth, AngularRate::fromDegrees(direction * rate));
                mount.turn(Axis::Elevation, AngularRate::fromDegrees(-0.8 * direction * rate));
                mount.run(Seconds(hold));
            }
        }
    }
    EXPECT_EQ(mount.report(), "");
}

// Story: with 300°/s² and 50 Nm each reversal overshot. The operator was advised not to re-arm before the motor had
// been calibrated.
// REQ-SUPERVISION-03
TEST(NoFalseFinding, AReversalWithTooLittleTorqueIsNoWrongWay)
{
    profile::Profile fast;
    fast.azimuth.limits.acceleration = AngularAcceleration::fromDegrees(300.0);
    fast.azimuth.limits.jerk = AngularJerk::fromDegrees(30000.0);
    sim::PairSettings pair = sim::commissionedPair({.azimuth = 180_deg, .elevation = 45_deg});
    pair.azimuth.plant.inertia = 60.0;
    SupervisedMount mount(pair, fast);
    mount.engage();
    for (int i = 0; i < 4; ++i) {
        mount.turn(Axis::Azimuth, 10_deg_s);
        mount.run(Seconds(2.0));
        mount.turn(Axis::Azimuth, -10_deg_s);
        mount.run(Seconds(2.0));
    }
    EXPECT_FALSE(mount.first(Symptom::WrongWay, Weight::Stop)) << mount.report();
    const auto late = mount.first(Symptom::FollowingError, Weight::Hint);
    ASSERT_TRUE(late) << mount.report();
    EXPECT_TRUE(late->observed.what.contains(QStringLiteral("limit 102 of the drive"))) << mount.report();
}

TEST(NoFalseFinding, CrawlsAndStepsOfATenthOfADegree)
{
    SupervisedMount mount;
    mount.engage();
    mount.turn(Axis::Azimuth, AngularRate::fromDegrees(0.004));  // sidereal rate
    mount.turn(Axis::Elevation, AngularRate::fromDegrees(0.03));
    mount.run(Seconds(300.0));
    for (int i = 1; i < 60; ++i) {
        mount.goTo(Axis::Azimuth, Angle::fromDegrees(2.0 + 0.1 * i));
        mount.goTo(Axis::Elevation, Angle::fromDegrees(20.0 + (i % 2 == 0 ? 0.1 : -0.1)));
        mount.run(Seconds(2.0));
    }
    EXPECT_EQ(mount.report(), "");
}

TEST(NoFalseFinding, EngagingSettingDownAndEngagingElsewhere)
{
    SupervisedMount mount(sim::commissionedPair({.azimuth = 0_deg, .elevation = 45_deg}));
    for (int i = 0; i < 5; ++i) {
        mount.engage();
        mount.turn(Axis::Azimuth, 10_deg_s);
        mount.turn(Axis::Elevation, (i % 2 == 0 ? 1.0 : -1.0) * 8_deg_s);
        mount.run(Seconds(3.0));
        mount.turn(Axis::Azimuth, {});
        mount.turn(Axis::Elevation, {});
        mount.run(Seconds(2.0));
        mount.release();
        mount.run(Seconds(5.0));
    }
    EXPECT_EQ(mount.report(), "");
}

TEST(NoFalseFinding, ADriveThatIsReleasedInMotionCoasts)
{
    SupervisedMount mount(sim::commissionedPair({.azimuth = 100_deg, .elevation = 45_deg}));
    mount.engage();
    mount.turn(Axis::Azimuth, 10_deg_s);
    mount.run(Seconds(3.0));
    const Angle released = mount.seen(Axis::Azimuth).actual;
    mount.release();
    mount.run(Seconds(10.0));
    EXPECT_GT(mount.seen(Axis::Azimuth).actual, released + 2_deg);
    EXPECT_EQ(mount.report(), "");
}

TEST(NoFalseFinding, OneReplyInAHundredIsLost)
{
    SupervisedMount mount;
    mount.inject(FaultKind::LostReply, Axis::Azimuth, 0.01);
    mount.inject(FaultKind::LostReply, Axis::Elevation, 0.01);
    mount.engage();
    mount.goTo(Axis::Azimuth, 440_deg);
    mount.goTo(Axis::Elevation, 90_deg);
    mount.run(Seconds(60.0));
    EXPECT_EQ(mount.report(), "");
}

// Gusts of one and a half times the tracking torque, in all directions.
TEST(NoFalseFinding, GustsDoNotStopTheMount)
{
    SupervisedMount mount(sim::commissionedPair({.azimuth = 0_deg, .elevation = 45_deg}));
    mount.engage();
    mount.turn(Axis::Azimuth, 1_deg_s);
    mount.turn(Axis::Elevation, 0.3_deg_s);
    mount.run(Seconds(5.0));
    const double tracking = std::abs(*mount.seen(Axis::Elevation).torque);
    ASSERT_GT(tracking, 4.0) << "friction";
    for (int i = 0; i < 8; ++i) {
        const double gust = (i % 2 == 0 ? 1.5 : -1.5) * tracking * (i < 4 ? 1.0 : 2.0);
        mount.inject(FaultKind::Wind, Axis::Azimuth, gust, Seconds(3.0));
        mount.inject(FaultKind::Wind, Axis::Elevation, gust, Seconds(3.0));
        mount.run(Seconds(8.0));
    }
    EXPECT_EQ(mount.report(), "");
    RecordProperty("tracking_torque_nm", std::to_string(tracking));
}

// The guided unwinding against a gust.
// REQ-SUPERVISION-10
TEST(NoFalseFinding, JoggingSlowlyWithAnUnknownTurn)
{
    sim::PairSettings pair = sim::commissionedPair();
    pair.azimuth.referenced = false;
    SupervisedMount mount(pair);
    mount.engage();
    ASSERT_FALSE(mount.seen(Axis::Azimuth).turnKnown);
    for (const double rate : {0.2, -0.2, 2.0, -2.0, 0.2, 0.0}) {
        mount.turn(Axis::Azimuth, AngularRate::fromDegrees(rate));
        mount.inject(FaultKind::Wind, Axis::Azimuth, 8.0, Seconds(3.0));
        mount.run(Seconds(5.0));
    }
    EXPECT_EQ(mount.report(), "");
}

}  // namespace
}  // namespace boresight::supervision
