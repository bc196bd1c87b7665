// SPDX-License-Identifier: GPL-3.0-or-later
// Requests of the operator's desk: trim, settings at run time, first moves of an unproven mount, single alarms.
#include "core/alarms/catalogue.h"
#include "tests/core/control/station_rig.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace boresight {
namespace {

using profile::Directions;

TEST(StationDesk, ANudgeWhileTrackingTrimsWhatTheClientAsks)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(50.0, 30.0, Seconds(30.0)));
    ASSERT_TRUE(rig.ask(request::Nudge{.azimuth = 0.5_deg, .elevation = -0.25_deg}));
    EXPECT_EQ(rig.control.status().authority, Authority::Clients) << "the client goes on leading";
    ASSERT_TRUE(rig.point(50.0, 30.0));
    rig.run(Seconds(5.0));
    EXPECT_NEAR(rig.azimuthDegrees(), 50.5, 0.02);
    EXPECT_NEAR(rig.elevationDegrees(), 29.75, 0.02);
    ASSERT_TRUE(rig.control.trimInUse());
    EXPECT_NEAR(rig.control.status().trim->azimuth.degrees(), 0.5, 1e-9);
    ASSERT_TRUE(rig.ask(request::ClearTrim{}));
    rig.run(Seconds(5.0));
    EXPECT_NEAR(rig.azimuthDegrees(), 50.0, 0.02);
    EXPECT_FALSE(rig.control.status().trim);
}

TEST(StationDesk, ATrimIsACorrectionNotAnotherTarget)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(50.0, 30.0, Seconds(1.0)));
    EXPECT_EQ(rig.ask(request::Nudge{.azimuth = 11_deg}).error().code, ErrorCode::OutOfRange);
    EXPECT_FALSE(rig.ask(request::ClearTrim{}, kClient));
}

// REQ-ALARMS-23c: A setting that is permitted but probably a mistake (`profile::adviceOn`) raises an advisory while it
// is in force.
TEST(StationDesk, AProfileWithoutBrakesIsAnAdvisoryForAsLongAsItIsInForce)
{
    StationRig rig;
    rig.run(Seconds(0.5));
    EXPECT_TRUE(rig.control.status().alarms.empty());
    rig.profile.azimuth.limits.acceleration = AngularAcceleration::fromDegrees(0.5);
    rig.profile.azimuth.limits.jerk = AngularJerk::fromDegrees(5.0);
    rig.setProfile(rig.profile);
    const auto alarms = rig.control.status().alarms;
    ASSERT_EQ(alarms.size(), 1U);
    EXPECT_EQ(alarms.front().severity, Severity::Advisory);
    EXPECT_EQ(alarms.front().what, QStringLiteral("The azimuth needs 20.2 s and 101° to stop from 10.0°/s."));
    rig.profile.azimuth.limits = profile::referenceAzimuth().limits;
    rig.setProfile(rig.profile);
    EXPECT_TRUE(rig.control.status().alarms.empty());
}

TEST(StationDesk, ANudgeWithoutAStreamIsAStep)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(50.0, 30.0, Seconds(30.0)));
    ASSERT_TRUE(rig.ask(request::Hold{}));
    ASSERT_TRUE(rig.ask(request::Nudge{.azimuth = 1_deg, .elevation = 0_deg}));
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 51.0, 0.05);
    EXPECT_FALSE(rig.control.status().trim);
}

// REQ-CONTROL-34: Unwrap turns the azimuth by a multiple of 360° to the wrap, inside the limits, where the cable is
// wound least.
TEST(StationDesk, UnwindTurnsBackToTheSameDirection)
{
    StationRig rig;  // travel -90…450°
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 425_deg, .elevation = 30_deg}}));
    rig.settle();
    ASSERT_TRUE(rig.ask(request::Unwind{}));
    EXPECT_EQ(rig.lastLog(),
              "moves the mount from 65.00° 30.00°: unwrap the cable, azimuth axis to 65.0°, there in 37 s");
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 65.0, 0.05);
    EXPECT_NEAR(rig.elevationDegrees(), 30.0, 0.05);
    const auto again = rig.ask(request::Unwind{});
    ASSERT_FALSE(again);
    EXPECT_EQ(textOf(again.error()), "The azimuth cable cannot be unwrapped further in this direction.");
}

// REQ-CONTROL-34
TEST(StationDesk, UnwindStaysInsideTheLimits)
{
    profile::Profile profile;
    profile.limits.azimuth = {100_deg, 450_deg};
    StationRig rig(profile);
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 425_deg, .elevation = 30_deg}}));
    rig.settle();
    EXPECT_FALSE(rig.ask(request::Unwind{})) << "65° is forbidden";
    EXPECT_EQ(rig.state(), StationState::Hold);
}

TEST(StationDesk, HorizonKeepsTheAzimuth)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(50.0, 30.0, Seconds(30.0)));
    ASSERT_TRUE(rig.ask(request::Horizon{}));
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 50.0, 0.05);
    EXPECT_NEAR(rig.elevationDegrees(), 0.0, 0.05);
}

// REQ-CONTROL-404 (StationOneAxis.*): A go-to of only one axis leaves the other axis where it stands or where it comes
// to a stop. The horizon may be the target of an azimuth go-to.
TEST(StationOneAxis, TheOtherAxisStaysWhereItIs)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(50.0, 30.0, Seconds(30.0)));
    ASSERT_TRUE(rig.ask(request::PointAxis{.axis = Axis::Azimuth, .angle = 80_deg}));
    EXPECT_EQ(rig.lastLog(), "moves the mount from 50.00° 30.00°: go to azimuth 80.00°, there in 4 s");
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 80.0, 0.01);
    EXPECT_NEAR(rig.elevationDegrees(), 30.0, 0.01);
    ASSERT_TRUE(rig.ask(request::PointAxis{.axis = Axis::Elevation, .angle = 12_deg}));
    EXPECT_EQ(rig.control.status().targetText, QStringLiteral("go to elevation 12.00°"));
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 80.0, 0.01);
    EXPECT_NEAR(rig.elevationDegrees(), 12.0, 0.01);
}

TEST(StationOneAxis, TheAzimuthKeepsItsTurnAndTakesTheNearestOne)
{
    StationRig rig;
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 405_deg, .elevation = 30_deg}}));
    rig.settle();
    ASSERT_TRUE(rig.ask(request::PointAxis{.axis = Axis::Elevation, .angle = 50_deg}));
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 405.0, 0.01);
    ASSERT_TRUE(rig.ask(request::PointAxis{.axis = Axis::Azimuth, .angle = 60_deg}));
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 420.0, 0.01);
}

// Story: the header said "go to azimuth 400.00°" while all other texts said 40.00°.
TEST(StationOneAxis, TheTextOfItsAzimuthHasNoTurns)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(50.0, 30.0, Seconds(30.0)));
    ASSERT_TRUE(rig.ask(request::PointAxis{.axis = Axis::Azimuth, .angle = 400_deg}));
    EXPECT_EQ(rig.control.status().targetText, QStringLiteral("go to azimuth 40.00°"));
    ASSERT_TRUE(rig.ask(request::PointAxis{.axis = Axis::Azimuth, .angle = -45_deg}));
    EXPECT_EQ(rig.control.status().targetText, QStringLiteral("go to azimuth 315.00°"));
}

// The other axis neither goes on to its old target nor returns to where it was.
TEST(StationOneAxis, AnAxisThatMovesStops)
{
    StationRig rig;
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.point(170, 30, kOperator));
    rig.run(Seconds(5.0));
    const double before = rig.azimuthDegrees();
    ASSERT_TRUE(rig.ask(request::PointAxis{.axis = Axis::Elevation, .angle = 60_deg}));
    double farthest = before;
    for (int i = 0; i < 500; ++i) {
        rig.tick();
        farthest = std::max(farthest, rig.azimuthDegrees());
    }
    EXPECT_NEAR(rig.azimuthDegrees(), farthest, 0.01);
    EXPECT_LT(farthest, before + 8.0);
    EXPECT_NEAR(rig.elevationDegrees(), 60.0, 0.01);
}

TEST(StationOneAxis, OverTheTopTheAzimuthIsThatOfTheBeam)
{
    profile::Profile profile;
    profile.elevation.geometry.travel = {0_deg, 180_deg};
    StationRig rig(profile);
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 100_deg, .elevation = 120_deg}}));
    rig.settle();
    ASSERT_TRUE(rig.ask(request::PointAxis{.axis = Axis::Azimuth, .angle = 300_deg}));
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 120.0, 0.01);
    EXPECT_NEAR(rig.elevationDegrees(), 120.0, 0.01);
}

TEST(StationOneAxis, WhatIsOutsideIsRefused)
{
    StationRig rig;
    rig.run(Seconds(0.2));
    const auto text = [&](const request::PointAxis& wanted) {
        const auto answer = rig.ask(wanted);
        return answer ? std::string() : textOf(answer.error());
    };
    EXPECT_EQ(text({.axis = Axis::Elevation, .angle = 95_deg}), "elevation 95.00° above limit 90.00°");
    EXPECT_EQ(text({.axis = Axis::Elevation, .angle = -3_deg}), "elevation -3.0° below limit 0.0°");
    EXPECT_EQ(rig.commands(), 0U);
}

TEST(StationOneAxis, TheHorizonAtAnAzimuth)
{
    profile::Profile profile;
    profile.limits.horizon = {{210_deg, 25_deg}, {214_deg, 0_deg}, {262_deg, 0_deg}, {266_deg, 25_deg}};
    StationRig rig(profile);
    ASSERT_TRUE(rig.setsOff(50.0, 60.0, Seconds(30.0)));
    ASSERT_TRUE(rig.ask(request::Horizon{.azimuth = 240_deg}));
    rig.settle();
    EXPECT_NEAR(std::remainder(rig.azimuthDegrees() - 240.0, 360.0), 0.0, 0.01);
    EXPECT_NEAR(rig.elevationDegrees(), 0.0, 0.01);
    ASSERT_TRUE(rig.ask(request::Horizon{.azimuth = 120_deg}));
    rig.settle();
    EXPECT_NEAR(std::remainder(rig.azimuthDegrees() - 120.0, 360.0), 0.0, 0.01);
    EXPECT_NEAR(rig.elevationDegrees(), 25.0, 0.01);
}

TEST(StationDesk, AProfileThatMakesNoSenseIsRefusedWithItsKey)
{
    StationRig rig;
    rig.run(Seconds(0.2));
    profile::Profile odd = rig.profile;
    odd.jog.slow = 9_deg_s;
    const Result<> answer = rig.ask(request::ApplyProfile{odd});
    ASSERT_FALSE(answer);
    EXPECT_NE(textOf(answer.error()).find("jog."), std::string::npos);
    EXPECT_FALSE(rig.ask(request::ApplyProfile{rig.profile}, kClient)) << "settings are the operator's";
}

TEST(StationDesk, NewSettingsAreInForceWithTheNextRequest)
{
    StationRig rig;
    rig.run(Seconds(0.2));
    profile::Profile changed = rig.profile;
    changed.park = {.azimuth = 33_deg, .elevation = 12_deg};
    rig.setProfile(changed);
    ASSERT_TRUE(rig.ask(request::Park{}));
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 33.0, 0.05);
}

// REQ-CONTROL-30: Before the directions are confirmed, the mount is moved only by a jog, or by `M` of a client. The
// speed is at most 5°/s. The axis stays within 2° of the place where the first such motion began. When confirmed
// directions become unconfirmed, the same 2° count from the present position. At the start the log says how to confirm
// the directions.
TEST(StationDesk, BeforeItsDirectionsAreConfirmedAMountIsJoggedALittleAndSlowly)
{
    profile::Profile fresh;
    fresh.mount.directions = Directions::Unconfirmed;
    StationRig rig(fresh);
    rig.run(Seconds(0.2));
    EXPECT_FALSE(rig.point(50.0, 30.0));
    EXPECT_FALSE(rig.ask(request::Park{}));
    EXPECT_FALSE(rig.ask(request::Jog{{.azimuth = 5.5_deg_s}}));
    double farthest = 0.0;
    for (int repeat = 0; repeat < 200; ++repeat) {
        (void)rig.ask(request::Jog{{.azimuth = repeat < 100 ? 5_deg_s : 0.5_deg_s}});
        rig.tick();
        farthest = std::max(farthest, rig.azimuthDegrees());
    }
    EXPECT_LE(farthest, 2.0);
    EXPECT_GE(farthest, 1.2);
    EXPECT_TRUE(rig.ask(request::Jog{{.azimuth = -1_deg_s}})) << "the way back";
    rig.run(Seconds(1.0));
    fresh.mount.directions = Directions::Confirmed;
    rig.setProfile(fresh);
    EXPECT_TRUE(rig.point(50.0, 30.0, kOperator));
}

// If there is no window, a person at the mast checks the directions with `M` of a client.
// REQ-CONTROL-30
TEST(StationDesk, BeforeItsDirectionsAreConfirmedAClientMovesItALittleAndSlowly)
{
    profile::Profile fresh;
    fresh.mount.directions = Directions::Unconfirmed;
    StationRig rig(fresh);
    rig.run(Seconds(0.2));
    EXPECT_FALSE(rig.point(50.0, 30.0));
    EXPECT_FALSE(rig.ask(request::Move{{.elevation = 5.5_deg_s}}, kClient));
    ASSERT_TRUE(rig.ask(request::Move{{.elevation = 1_deg_s}}, kClient));
    rig.run(Seconds(5.0));
    EXPECT_EQ(rig.state(), StationState::Hold);
    EXPECT_GE(rig.elevationDegrees(), 1.7);
    EXPECT_LE(rig.elevationDegrees(), 2.0);
    EXPECT_FALSE(rig.ask(request::Move{{.elevation = 1_deg_s}}, kClient));
    ASSERT_TRUE(rig.ask(request::Move{{.elevation = -1_deg_s}}, kClient)) << "the way back";
    ASSERT_TRUE(rig.ask(request::TakeAuthority{}));
    EXPECT_FALSE(rig.ask(request::Move{{.elevation = -1_deg_s}}, kClient));
}

// Story from the guide: when the azimuth had used up its 2°, the elevation did not move at all.
TEST(StationDesk, AnAxisAtTheEndOfItsSmallWayKeepsNeitherTheOtherNorTheWayBack)
{
    profile::Profile fresh;
    fresh.mount.directions = Directions::Unconfirmed;
    StationRig rig(fresh);
    rig.run(Seconds(0.2));
    const auto jog = [&rig](const AxisRates& rates) {
        for (int repeat = 0; repeat < 150; ++repeat) {
            (void)rig.ask(request::Jog{rates});
            rig.tick();
        }
    };
    jog({.azimuth = 1_deg_s});
    const double end = rig.azimuthDegrees();
    EXPECT_GE(end, 1.7);
    jog({.elevation = 1_deg_s});
    EXPECT_GE(rig.elevationDegrees(), 1.7);
    EXPECT_LE(rig.elevationDegrees(), 2.0);
    jog({.azimuth = -1_deg_s});
    EXPECT_LE(rig.azimuthDegrees(), end - 2.0) << "back, and out on the other side";
    EXPECT_GE(rig.azimuthDegrees(), -2.0);
}

// REQ-CONTROL-30
TEST(StationDesk, DirectionsThatAreDoubtedAgainAllowASmallWayFromWhereTheMountStandsNow)
{
    profile::Profile fresh;
    fresh.mount.directions = Directions::Unconfirmed;
    StationRig rig(fresh);
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.ask(request::Jog{{.azimuth = 1_deg_s}}));
    rig.run(Seconds(1.0));
    fresh.mount.directions = Directions::Confirmed;
    rig.setProfile(fresh);
    ASSERT_TRUE(rig.point(50.0, 30.0, kOperator));
    rig.settle();
    fresh.mount.directions = Directions::Unconfirmed;  // for example because the motors are swapped
    rig.setProfile(fresh);
    EXPECT_FALSE(rig.point(60.0, 30.0, kOperator));
    for (int repeat = 0; repeat < 200; ++repeat) {
        (void)rig.ask(request::Jog{{.azimuth = 5_deg_s}});
        rig.tick();
    }
    EXPECT_GE(rig.azimuthDegrees(), 51.2);
    EXPECT_LE(rig.azimuthDegrees(), 52.0);
}

TEST(StationDesk, OneAlarmIsAcknowledgedAndTheOthersWait)
{
    StationRig rig;
    rig.control.alarms().raise(alarmEntry("bus.trouble").of(QStringLiteral("a")), {QStringLiteral("one")});
    rig.control.alarms().raise(alarmEntry("bus.trouble").of(QStringLiteral("b")), {QStringLiteral("two")});
    const std::uint64_t first = rig.control.status().alarms.front().id;
    ASSERT_TRUE(rig.ask(request::AcknowledgeAlarm{first}));
    for (const Alarm& alarm : rig.control.status().alarms) {
        EXPECT_EQ(alarm.acknowledged, alarm.id == first);
    }
}

TEST(StationDesk, TheLogTellsStartsOfMotionAndAlarmsApart)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(50.0, 30.0, Seconds(1.0)));
    rig.control.alarms().raise(alarmEntry("bus.trouble").of(QStringLiteral("a")), {QStringLiteral("one")});
    const auto lines = rig.log.since(0, EventLog::kCapacity);
    const auto count = [&](LogKind kind) { return std::ranges::count(lines, kind, &LogEntry::kind); };
    EXPECT_EQ(count(LogKind::MotionStart), 1);
    EXPECT_EQ(count(LogKind::Alarm), 1);
}

}  // namespace
}  // namespace boresight
