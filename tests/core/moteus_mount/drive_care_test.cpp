// SPDX-License-Identifier: GPL-3.0-or-later
// The drive check and the control of motion together.
#include "tests/core/moteus_mount/care_rig.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace boresight {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::vector<std::pair<Action, Request>> kOfTheDrives{{Action::ReadDrives, request::ReadDrives{}},
                                                           {Action::FixDrives, request::FixDrives{}},
                                                           {Action::ReleaseBus, request::ReleaseBus{}}};

sim::PairSettings dampingElevation()
{
    sim::PairSettings pair = sim::commissionedPair();
    pair.elevation.config.servo.timeoutMode = 12;
    return pair;
}

// REQ-CONTROL-18 (DriveCare.*): Nothing moves before the drive check has found the safety settings right. If they
// become wrong, motion ends.
// REQ-CONTROL-21 (DriveCare.*): The bus can be released to other tools. When it is taken back the drives are read
// again.
TEST(DriveCare, NothingMovesBeforeTheDrivesWereSurveyed)
{
    CareRig rig;
    rig.run(Seconds(0.5));
    EXPECT_EQ(rig.drives().driveCheck, DriveCheckState::Running) << "by itself, as soon as they answer";
    EXPECT_THAT(rig.ask(kGo), HasSubstr("drive check is running"));
    EXPECT_THAT(rig.drives().armingObstacle.toStdString(), HasSubstr("drive check is running"));
    ASSERT_TRUE(rig.endsItsDriveCheck());
    EXPECT_TRUE(rig.drives().armingObstacle.isEmpty()) << rig.drives().armingObstacle.toStdString();
    EXPECT_EQ(rig.ask(kGo), "");
    rig.run(Seconds(20.0));
    EXPECT_NEAR(rig.pair.truth(Axis::Azimuth).angle.degrees(), 30.0, 0.2);
}

TEST(DriveCare, TheDrivesReportTheirRegistersInWords)
{
    CareRig rig;
    EXPECT_EQ(rig.drives().azimuth.registers, QStringLiteral("moteus mode 0, fault 0")) << "never heard";
    ASSERT_TRUE(rig.endsItsDriveCheck());
    ASSERT_EQ(rig.ask(kGo), "");
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.drives().azimuth.registers, QStringLiteral("moteus mode 10, fault 0"));
}

TEST(DriveCare, AWrongProtectionRefusesMotionWithTheReasonAndAnAlarm)
{
    CareRig rig(dampingElevation());
    ASSERT_TRUE(rig.endsItsDriveCheck());
    EXPECT_THAT(rig.ask(kGo), HasSubstr("If commands stop is 12"));
    EXPECT_THAT(rig.ask(request::Jog{{.elevation = 1_deg_s}}), HasSubstr("If commands stop"));
    EXPECT_TRUE(rig.alarm("If commands stop is 12"));
    rig.run(Seconds(2.0));
    EXPECT_NEAR(rig.pair.truth(Axis::Elevation).angle.degrees(), 10.0, 0.1);
}

TEST(DriveCare, FixingMakesTheDrivesFitAndEndsTheAlarm)
{
    CareRig rig(dampingElevation());
    ASSERT_TRUE(rig.endsItsDriveCheck());
    ASSERT_TRUE(rig.drives().fixable);
    const auto lines = rig.drives().elevation.protections;
    const auto wrong = std::ranges::find(lines, QStringLiteral("servo.timeout_mode"), &ProtectionLine::key);
    ASSERT_NE(wrong, lines.end());
    EXPECT_EQ(wrong->verdict, Verdict::Dangerous);
    EXPECT_EQ(wrong->fix, QStringLiteral("10 (hold)")) << "the screen lists it before it is written";
    ASSERT_EQ(rig.ask(request::FixDrives{}), "");
    EXPECT_EQ(rig.drives().driveCheck, DriveCheckState::Fixing);
    for (const auto& [action, wanted] : kOfTheDrives) {
        EXPECT_THAT(rig.obstacle(action), HasSubstr("is writing the settings"));
        EXPECT_EQ(rig.refusal(wanted), rig.obstacle(action));
    }
    EXPECT_NE(rig.ask(kGo), "");
    ASSERT_TRUE(rig.endsItsDriveCheck());
    EXPECT_EQ(rig.pair.drive(Axis::Elevation).driveConfig().servo.timeoutMode, 10);
    EXPECT_FALSE(rig.alarm("servo.timeout_mode"));
    EXPECT_FALSE(rig.drives().fixable);
    EXPECT_TRUE(rig.logSays("written: elevation: servo.timeout_mode was 12 (damp), is 10 (hold)"));
    EXPECT_FALSE(rig.logSays("changed meanwhile")) << "nobody else has touched it";
    EXPECT_EQ(rig.ask(kGo), "");
}

// Story: a new speed was in effect, but the limits of the drives were checked, shown and written by Fix for the speed
// at the start.
TEST(DriveCare, TheProtectionsAreThoseOfTheProfileInForce)
{
    CareRig rig;
    ASSERT_TRUE(rig.endsItsDriveCheck());
    ASSERT_FALSE(rig.drives().fixable);
    profile::Profile faster = rig.profile;
    faster.azimuth.limits.speed = 2.0 * faster.azimuth.limits.speed;
    rig.setProfile(faster);
    ASSERT_TRUE(rig.drives().fixable);
    ASSERT_EQ(rig.ask(request::FixDrives{}), "");
    rig.setProfile(rig.profile);
    ASSERT_TRUE(rig.endsItsDriveCheck());
    EXPECT_TRUE(rig.logSays("written: azimuth: servo.default_velocity_limit was"));
    EXPECT_TRUE(rig.drives().fixable) << "changed back meanwhile";
    ASSERT_EQ(rig.ask(request::FixDrives{}), "");
    ASSERT_TRUE(rig.endsItsDriveCheck());
    EXPECT_FALSE(rig.drives().fixable);
}

TEST(DriveCare, WhatIsReadOrRightIsNotOfferedAgain)
{
    CareRig rig;
    ASSERT_TRUE(rig.reaches(DriveCheckState::Running));
    EXPECT_EQ(rig.obstacle(Action::ReadDrives), "Boresight is reading the drives. Wait a moment.");
    EXPECT_EQ(rig.refusal(request::ReadDrives{}), "Boresight is reading the drives. Wait a moment.");
    EXPECT_EQ(rig.obstacle(Action::FixDrives), "Boresight is reading the drives. Wait a moment.");
    ASSERT_TRUE(rig.endsItsDriveCheck());
    EXPECT_EQ(rig.obstacle(Action::ReadDrives), "");
    EXPECT_EQ(rig.obstacle(Action::FixDrives), "every setting is right");
    EXPECT_EQ(rig.refusal(request::FixDrives{}), "every setting is right");
    EXPECT_EQ(rig.ask(request::ReadDrives{}), "");
}

// A drive that is written while it is active loses its torque (fault 41).
TEST(DriveCare, NothingIsWrittenWhileADriveIsSwitchedOn)
{
    CareRig rig;
    ASSERT_TRUE(rig.endsItsDriveCheck());
    ASSERT_EQ(rig.ask(kGo), "");
    rig.run(Seconds(20.0));
    rig.otherToolSays(Axis::Elevation, "conf set servo.default_timeout_s 1");
    EXPECT_THAT(rig.ask(request::FixDrives{}), HasSubstr("switched on"));
    ASSERT_EQ(rig.ask(request::ReadDrives{}), "");
    rig.tick();
    ASSERT_TRUE(rig.endsItsDriveCheck());
    EXPECT_TRUE(rig.alarm("Watchdog time is 1 s"));
    EXPECT_THAT(rig.ask(request::FixDrives{}), HasSubstr("switched on"));
    EXPECT_EQ(rig.pair.truth(Axis::Elevation).mode, moteus::Mode::Position) << "the reading has not disturbed it";
    ASSERT_EQ(rig.ask(request::SwitchOff{}), "");
    rig.run(Seconds(0.5));
    EXPECT_EQ(rig.ask(request::FixDrives{}), "");
    rig.tick();
    ASSERT_TRUE(rig.reaches(DriveCheckState::Done));
    EXPECT_EQ(rig.pair.drive(Axis::Elevation).driveConfig().servo.defaultTimeout, 0.1);
}

TEST(DriveCare, ADriveThatLostItsPowerIsSurveyedAndItsTurnJudgedAnew)
{
    CareRig rig;
    ASSERT_TRUE(rig.endsItsDriveCheck());
    ASSERT_EQ(rig.ask(kGo), "");
    rig.run(Seconds(20.0));
    rig.pair.faults().add({.kind = sim::FaultKind::PowerLoss, .at = rig.elapsed, .duration = Seconds(2.0)});
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.drives().driveCheck, DriveCheckState::NotDone) << "who comes back may be another";
    rig.run(Seconds(1.5));
    ASSERT_TRUE(rig.endsItsDriveCheck());
    EXPECT_FALSE(rig.control.status().azimuth.turnKnown);
    EXPECT_FALSE(rig.control.status().elevation.turnKnown);
    for (const DriveStatus& drive : {rig.drives().azimuth, rig.drives().elevation}) {
        ASSERT_TRUE(drive.turnQuestion);
        EXPECT_FALSE(drive.turnQuestion->evidence.empty());
    }
    EXPECT_TRUE(rig.alarm("cable wrap of the azimuth drive is unknown"));
    EXPECT_TRUE(rig.alarm("position of the elevation drive is unknown")) << "the elevation has no cable";
}

// Story: each time a silent drive came back, its wrap raised an alarm until the drive check had found that it was
// unchanged.
TEST(DriveCare, ATurnIsNoAlarmBeforeTheSurveyCouldTellIt)
{
    CareRig rig;
    ASSERT_TRUE(rig.reaches(DriveCheckState::Done));
    rig.run(Seconds(0.2));
    rig.pair.faults().add({.kind = sim::FaultKind::Silence, .at = rig.elapsed, .duration = Seconds(2.0)});
    rig.run(Seconds(2.5));
    ASSERT_TRUE(rig.reaches(DriveCheckState::Done));
    rig.run(Seconds(0.2));
    EXPECT_TRUE(rig.control.status().azimuth.turnKnown);
    EXPECT_FALSE(rig.logSays("cable wrap of"));
    EXPECT_FALSE(rig.logSays("position of the elevation drive is unknown"));
}

TEST(DriveCare, OnAReleasedBusNothingIsSaidAndChangesAreToldAfterwards)
{
    CareRig rig;
    ASSERT_TRUE(rig.endsItsDriveCheck());
    ASSERT_EQ(rig.ask(request::ReleaseBus{}), "");
    rig.linkOpen = false;
    rig.checked = false;
    rig.run(Seconds(5.0));
    EXPECT_FALSE(rig.checked);
    EXPECT_THAT(rig.ask(kGo), HasSubstr("released to other tools"));
    for (const Alarm& alarm : rig.control.status().alarms) {
        EXPECT_FALSE(alarm.active) << "a silence that was asked for is no alarm: " << alarm.what.toStdString();
    }
    rig.otherToolSays(Axis::Azimuth, "conf set servo.timeout_mode 12");
    ASSERT_EQ(rig.ask(request::TakeBus{}), "");
    rig.linkOpen = true;
    rig.run(Seconds(0.2));
    EXPECT_FALSE(rig.logSays("No reply")) << "they had no question yet";
    ASSERT_TRUE(rig.endsItsDriveCheck());
    EXPECT_TRUE(rig.logSays("changed meanwhile: azimuth: servo.timeout_mode was 10 (hold), is 12 (damp)"));
    EXPECT_THAT(rig.ask(kGo), HasSubstr("If commands stop is 12"));
}

// Story: the screen showed "no reply" for ever. Each of two boards with the id 1 destroyed the replies of the other.
// The drive check knows the one query that both can answer, but it waited for a drive to reply first.
// REQ-ALARMS-29
TEST(DriveCare, TwoBoardsWithOneIdAreRecognisedByThemselves)
{
    CareRig rig(sim::factoryPair());
    rig.run(Seconds(4.0));
    EXPECT_TRUE(rig.alarm("Neither drive replies"));
    ASSERT_TRUE(rig.alarm("wo boards have the id 1"));
    EXPECT_TRUE(rig.control.status().alarms.front().what.contains(QStringLiteral("wo boards have the id 1")))
        << "the cause before what it leads to";
    EXPECT_THAT(rig.ask(kGo), Not(""));
}

TEST(DriveCare, NobodyAtAllIsToldOnceOnly)
{
    CareRig rig;
    rig.linkOpen = false;
    rig.run(Seconds(8.0));
    EXPECT_EQ(rig.control.status().alarms.size(), 1U);
    EXPECT_TRUE(rig.checked);
    rig.linkOpen = true;
    ASSERT_TRUE(rig.reaches(DriveCheckState::Done));
    rig.run(Seconds(0.2));
    EXPECT_EQ(rig.ask(kGo), "");
}

}  // namespace
}  // namespace boresight
