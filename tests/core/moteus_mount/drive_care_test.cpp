// SPDX-License-Identifier: GPL-3.0-or-later
// The survey of the drives and the control of motion together, on drives with consoles of their own.
#include "core/moteus_mount/drive_care.h"

#include "core/sim/simulated_pair.h"
#include "tests/core/control/station_rig.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

namespace boresight {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr Seconds kDriveCareTick{0.02};
const std::vector<std::pair<Action, Request>> kOfTheDrives{{Action::ReadDrives, request::ReadDrives{}},
                                                           {Action::FixDrives, request::FixDrives{}},
                                                           {Action::ReleaseBus, request::ReleaseBus{}}};

struct CareRig
{
    explicit CareRig(const sim::PairSettings& settings = sim::commissionedPair()) : pair(settings) {}

    void tick()
    {
        control.tick();
        const auto motion = mount.frames();
        std::vector<CanFrame> frames(motion.begin(), motion.end());
        std::ranges::copy(care.tick(clock.now()), std::back_inserter(frames));
        sent = 0;
        if (linkOpen) {
            sent = frames.size();
            for (const CanFrame& frame : frames) {
                std::ranges::copy(pair.exchange(frame, elapsed), std::back_inserter(underWay));
            }
        }
        mount.framesSent();
        surveyed = surveyed || frames.size() > motion.size();
        clock.advance(kDriveCareTick);
        elapsed += kDriveCareTick;
        pair.advanceTo(elapsed);
        deliver();
    }

    void run(Seconds time)
    {
        for (const Seconds end = elapsed + time; elapsed < end;) {
            tick();
        }
    }

    bool reaches(SurveyState state, Seconds within = Seconds(12.0))
    {
        for (const Seconds end = elapsed + within; elapsed < end && drives().survey != state;) {
            tick();
        }
        return drives().survey == state;
    }

    // And the station has heard what came of it.
    [[nodiscard]] bool endsItsSurvey()
    {
        const bool ended = reaches(SurveyState::Done);
        run(Seconds(0.2));
        return ended;
    }

    [[nodiscard]] DrivesStatus drives() const
    {
        DrivesStatus status = *control.status().drives;
        care.fill(status);
        return status;
    }

    [[nodiscard]] std::string obstacle(Action action) const
    {
        Permissions may = control.status().permissions;
        care.judge(may);
        return may.reason(action).toStdString();
    }

    // Before the control is asked.
    [[nodiscard]] std::string refusal(const Request& request) const
    {
        const Result<> may = care.admits(request);
        return may ? std::string() : textOf(may.error());
    }

    // As the station does it; empty when accepted.
    std::string ask(const Request& request)
    {
        const Result<> answer =
            control.request(request, kOperator).and_then([&] { return care.carryOut(request, clock.now()); });
        return answer ? std::string() : textOf(answer.error());
    }

    // As the station does it.
    void setProfile(const profile::Profile& wanted)
    {
        const auto before = inForce.shared();
        inForce.apply(wanted);
        control.profileChanged(*before, *inForce);
        care.profileChanged(*before, *inForce);
    }

    void otherToolSays(Axis axis, const std::string& command)
    {
        const std::string text = command + '\n';
        pair.drive(axis).receiveText(1, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    }

    [[nodiscard]] bool alarm(const char* words) const
    {
        return std::ranges::any_of(control.status().alarms, [&](const Alarm& one) {
            return one.active && one.what.contains(QString::fromUtf8(words));
        });
    }

    [[nodiscard]] bool logSays(const char* words) const
    {
        return std::ranges::any_of(log.since(0, EventLog::kCapacity),
                                   [&](const LogEntry& line) { return line.text.contains(QString::fromUtf8(words)); });
    }

    fakes::ManualClock clock;
    EventLog log{clock};
    profile::Profile profile;
    profile::InForce inForce{profile};
    AlarmBoard alarms{log, clock};
    MoteusMount mount{inForce, clock, log, alarms, {.trustFirstContact = true}};
    StationControl control{inForce, clock, log, alarms, mount, motionSources};
    DriveCare care{inForce, mount, alarms, log};
    sim::SimulatedPair pair;
    Seconds elapsed{0.0};
    bool linkOpen = true;
    std::size_t sent = 0;   // frames in the last tick
    bool surveyed = false;  // DriveCare has sent something

private:
    void deliver()
    {
        std::deque<sim::PairReply> later;
        for (const sim::PairReply& reply : underWay) {
            if (reply.due > elapsed) {
                later.push_back(reply);
                continue;
            }
            CanFrame frame = reply.frame;
            frame.received = clock.now();
            mount.take(frame);
            care.take(frame);
        }
        underWay = std::move(later);
    }

    std::deque<sim::PairReply> underWay;
};

const Request kGo = request::PointAxes{{.azimuth = 30_deg, .elevation = 30_deg}};

sim::PairSettings dampingElevation()
{
    sim::PairSettings pair = sim::commissionedPair();
    pair.elevation.config.servo.timeoutMode = 12;
    return pair;
}

// REQ-CONTROL-18 (DriveCare.*): Nothing moves before the drives were checked and their safety settings are right, nor
// any longer than they are.
// REQ-CONTROL-21 (DriveCare.*): The bus can be left to other tools. On return the drives are read again.
TEST(DriveCare, NothingMovesBeforeTheDrivesWereSurveyed)
{
    CareRig rig;
    rig.run(Seconds(0.5));
    EXPECT_EQ(rig.drives().survey, SurveyState::Running) << "by itself, as soon as they answer";
    EXPECT_THAT(rig.ask(kGo), HasSubstr("drive check is running"));
    EXPECT_THAT(rig.drives().armingObstacle.toStdString(), HasSubstr("drive check is running"));
    ASSERT_TRUE(rig.endsItsSurvey());
    EXPECT_TRUE(rig.drives().armingObstacle.isEmpty()) << rig.drives().armingObstacle.toStdString();
    EXPECT_EQ(rig.ask(kGo), "");
    rig.run(Seconds(20.0));
    EXPECT_NEAR(rig.pair.truth(Axis::Azimuth).angle.degrees(), 30.0, 0.2);
}

TEST(DriveCare, TheDrivesReportTheirRegistersInWords)
{
    CareRig rig;
    EXPECT_EQ(rig.drives().azimuth.registers, QStringLiteral("moteus mode 0, fault 0")) << "never heard";
    ASSERT_TRUE(rig.endsItsSurvey());
    ASSERT_EQ(rig.ask(kGo), "");
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.drives().azimuth.registers, QStringLiteral("moteus mode 10, fault 0"));
}

TEST(DriveCare, AWrongProtectionRefusesMotionWithTheReasonAndAnAlarm)
{
    CareRig rig(dampingElevation());
    ASSERT_TRUE(rig.endsItsSurvey());
    EXPECT_THAT(rig.ask(kGo), HasSubstr("servo.timeout_mode is 12"));
    EXPECT_THAT(rig.ask(request::Jog{{.elevation = 1_deg_s}}), HasSubstr("servo.timeout_mode"));
    EXPECT_TRUE(rig.alarm("servo.timeout_mode is 12"));
    rig.run(Seconds(2.0));
    EXPECT_NEAR(rig.pair.truth(Axis::Elevation).angle.degrees(), 10.0, 0.1);
}

TEST(DriveCare, FixingMakesTheDrivesFitAndEndsTheAlarm)
{
    CareRig rig(dampingElevation());
    ASSERT_TRUE(rig.endsItsSurvey());
    ASSERT_TRUE(rig.drives().fixable);
    const auto lines = rig.drives().elevation.protections;
    const auto wrong = std::ranges::find(lines, QStringLiteral("servo.timeout_mode"), &ProtectionLine::key);
    ASSERT_NE(wrong, lines.end());
    EXPECT_EQ(wrong->verdict, Verdict::Dangerous);
    EXPECT_EQ(wrong->fix, QStringLiteral("10 (hold)")) << "the screen lists it before it is written";
    ASSERT_EQ(rig.ask(request::FixDrives{}), "");
    EXPECT_EQ(rig.drives().survey, SurveyState::Fixing);
    for (const auto& [action, wanted] : kOfTheDrives) {
        EXPECT_THAT(rig.obstacle(action), HasSubstr("settings are being written"));
        EXPECT_EQ(rig.refusal(wanted), rig.obstacle(action));
    }
    EXPECT_NE(rig.ask(kGo), "");
    ASSERT_TRUE(rig.endsItsSurvey());
    EXPECT_EQ(rig.pair.drive(Axis::Elevation).driveConfig().servo.timeoutMode, 10);
    EXPECT_FALSE(rig.alarm("servo.timeout_mode"));
    EXPECT_FALSE(rig.drives().fixable);
    EXPECT_TRUE(rig.logSays("written: elevation: servo.timeout_mode was 12 (damp), is 10 (hold)"));
    EXPECT_FALSE(rig.logSays("changed meanwhile")) << "nobody else has touched it";
    EXPECT_EQ(rig.ask(kGo), "");
}

// Story: with a new speed in force, the drives' limits were judged, shown and written by Fix for the speed of the
// start.
TEST(DriveCare, TheProtectionsAreThoseOfTheProfileInForce)
{
    CareRig rig;
    ASSERT_TRUE(rig.endsItsSurvey());
    ASSERT_FALSE(rig.drives().fixable);
    profile::Profile faster = rig.profile;
    faster.azimuth.limits.speed = 2.0 * faster.azimuth.limits.speed;
    rig.setProfile(faster);
    ASSERT_TRUE(rig.drives().fixable);
    ASSERT_EQ(rig.ask(request::FixDrives{}), "");
    rig.setProfile(rig.profile);
    ASSERT_TRUE(rig.endsItsSurvey());
    EXPECT_TRUE(rig.logSays("written: azimuth: servo.default_velocity_limit was"));
    EXPECT_TRUE(rig.drives().fixable) << "changed back meanwhile";
    ASSERT_EQ(rig.ask(request::FixDrives{}), "");
    ASSERT_TRUE(rig.endsItsSurvey());
    EXPECT_FALSE(rig.drives().fixable);
}

TEST(DriveCare, WhatIsReadOrRightIsNotOfferedAgain)
{
    CareRig rig;
    ASSERT_TRUE(rig.reaches(SurveyState::Running));
    EXPECT_EQ(rig.obstacle(Action::ReadDrives), "the drives are being read");
    EXPECT_EQ(rig.refusal(request::ReadDrives{}), "the drives are being read");
    EXPECT_EQ(rig.obstacle(Action::FixDrives), "the drives are being read");
    ASSERT_TRUE(rig.endsItsSurvey());
    EXPECT_EQ(rig.obstacle(Action::ReadDrives), "");
    EXPECT_EQ(rig.obstacle(Action::FixDrives), "every setting is right");
    EXPECT_EQ(rig.refusal(request::FixDrives{}), "every setting is right");
    EXPECT_EQ(rig.ask(request::ReadDrives{}), "");
}

// A drive that is written while it is active lets its axis go (fault 41).
TEST(DriveCare, NothingIsWrittenWhileADriveIsSwitchedOn)
{
    CareRig rig;
    ASSERT_TRUE(rig.endsItsSurvey());
    ASSERT_EQ(rig.ask(kGo), "");
    rig.run(Seconds(20.0));
    rig.otherToolSays(Axis::Elevation, "conf set servo.default_timeout_s 1");
    EXPECT_THAT(rig.ask(request::FixDrives{}), HasSubstr("switched on"));
    ASSERT_EQ(rig.ask(request::ReadDrives{}), "");
    rig.tick();
    ASSERT_TRUE(rig.endsItsSurvey());
    EXPECT_TRUE(rig.alarm("servo.default_timeout_s is 1 s"));
    EXPECT_THAT(rig.ask(request::FixDrives{}), HasSubstr("switched on"));
    EXPECT_EQ(rig.pair.truth(Axis::Elevation).mode, moteus::Mode::Position) << "the reading has not disturbed it";
    ASSERT_EQ(rig.ask(request::SwitchOff{}), "");
    rig.run(Seconds(0.5));
    EXPECT_EQ(rig.ask(request::FixDrives{}), "");
    rig.tick();
    ASSERT_TRUE(rig.reaches(SurveyState::Done));
    EXPECT_EQ(rig.pair.drive(Axis::Elevation).driveConfig().servo.defaultTimeout, 0.1);
}

TEST(DriveCare, ADriveThatLostItsPowerIsSurveyedAndItsTurnJudgedAnew)
{
    CareRig rig;
    ASSERT_TRUE(rig.endsItsSurvey());
    ASSERT_EQ(rig.ask(kGo), "");
    rig.run(Seconds(20.0));
    rig.pair.faults().add({.kind = sim::FaultKind::PowerLoss, .at = rig.elapsed, .duration = Seconds(2.0)});
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.drives().survey, SurveyState::NotDone) << "who comes back may be another";
    rig.run(Seconds(1.5));
    ASSERT_TRUE(rig.endsItsSurvey());
    EXPECT_FALSE(rig.control.status().azimuth.turnKnown);
    EXPECT_FALSE(rig.control.status().elevation.turnKnown);
    for (const DriveStatus& drive : {rig.drives().azimuth, rig.drives().elevation}) {
        ASSERT_TRUE(drive.turnQuestion);
        EXPECT_FALSE(drive.turnQuestion->evidence.empty());
    }
    EXPECT_TRUE(rig.alarm("cable wrap of the azimuth drive is unknown"));
}

// Story: each time that a silent drive came back its turn was an alarm, until the survey had found that it was the
// same.
TEST(DriveCare, ATurnIsNoAlarmBeforeTheSurveyCouldTellIt)
{
    CareRig rig;
    ASSERT_TRUE(rig.reaches(SurveyState::Done));
    rig.run(Seconds(0.2));
    rig.pair.faults().add({.kind = sim::FaultKind::Silence, .at = rig.elapsed, .duration = Seconds(2.0)});
    rig.run(Seconds(2.5));
    ASSERT_TRUE(rig.reaches(SurveyState::Done));
    rig.run(Seconds(0.2));
    EXPECT_TRUE(rig.control.status().azimuth.turnKnown);
    EXPECT_FALSE(rig.logSays("cable wrap of"));
}

TEST(DriveCare, OnAReleasedBusNothingIsSaidAndChangesAreToldAfterwards)
{
    CareRig rig;
    ASSERT_TRUE(rig.endsItsSurvey());
    ASSERT_EQ(rig.ask(request::ReleaseBus{}), "");
    rig.linkOpen = false;
    rig.surveyed = false;
    rig.run(Seconds(5.0));
    EXPECT_FALSE(rig.surveyed);
    EXPECT_THAT(rig.ask(kGo), HasSubstr("released to other tools"));
    for (const Alarm& alarm : rig.control.status().alarms) {
        EXPECT_FALSE(alarm.active) << "a silence that was asked for is no alarm: " << alarm.what.toStdString();
    }
    rig.otherToolSays(Axis::Azimuth, "conf set servo.timeout_mode 12");
    ASSERT_EQ(rig.ask(request::TakeBus{}), "");
    rig.linkOpen = true;
    rig.run(Seconds(0.2));
    EXPECT_FALSE(rig.logSays("No reply")) << "they had no question yet";
    ASSERT_TRUE(rig.endsItsSurvey());
    EXPECT_TRUE(rig.logSays("changed meanwhile: azimuth: servo.timeout_mode was 10 (hold), is 12 (damp)"));
    EXPECT_THAT(rig.ask(kGo), HasSubstr("servo.timeout_mode is 12"));
}

// Story: the screen said "no reply" for ever: each of two boards with the id 1 destroyed the other's answers, and the
// survey that knows the one question both can answer waited for a drive to answer.
// REQ-ALARMS-29
TEST(DriveCare, TwoBoardsWithOneIdAreRecognisedByThemselves)
{
    CareRig rig(sim::factoryPair());
    rig.run(Seconds(4.0));
    EXPECT_TRUE(rig.alarm("The azimuth drive does not reply"));
    ASSERT_TRUE(rig.alarm("wo boards have the id 1"));
    EXPECT_TRUE(rig.control.status().alarms.front().what.contains(QStringLiteral("wo boards have the id 1")))
        << "the cause before what it leads to";
    EXPECT_THAT(rig.ask(kGo), Not(""));
}

TEST(DriveCare, NobodyAtAllIsToldOncePerDriveOnly)
{
    CareRig rig;
    rig.linkOpen = false;
    rig.run(Seconds(8.0));
    EXPECT_EQ(rig.control.status().alarms.size(), 2U);
    EXPECT_TRUE(rig.surveyed);
    rig.linkOpen = true;
    ASSERT_TRUE(rig.reaches(SurveyState::Done));
    rig.run(Seconds(0.2));
    EXPECT_EQ(rig.ask(kGo), "");
}

// Holds at the end of kGo, with the gains of the azimuth read.
struct GainsAtRest : CareRig
{
    explicit GainsAtRest(const sim::PairSettings& settings = sim::commissionedPair()) : CareRig(settings)
    {
        EXPECT_TRUE(endsItsSurvey());
    }

    bool read() { return ask(request::ReadGains{}) == "" && settles() && drives().azimuth.gains.read; }

    bool settles()
    {
        run(Seconds(1.0));
        for (int i = 0; i < 200 && drives().azimuth.gains.busy; ++i) {
            tick();
        }
        return !drives().azimuth.gains.busy;
    }

    std::string set(Gain gain, double factor)
    {
        const request::SetGain wanted{
            .gain = gain, .value = factor * *drives().azimuth.gains.lines[static_cast<std::size_t>(gain)].value};
        const std::string refused = refusal(wanted);
        return refused.empty() ? ask(wanted) : refused;
    }
};

// REQ-AXES-960 (DriveCare.Gains*): Gains are changed while the axis stands, also while its drive holds it. What begins
// the count of the encoder anew, and storing, needs the drives off.
TEST(DriveCare, GainsAreChangedUnderADriveThatHolds)
{
    GainsAtRest rig;
    EXPECT_THAT(rig.obstacle(Action::SetAzimuthGains), HasSubstr("Read the gains first"));
    ASSERT_TRUE(rig.read());
    ASSERT_EQ(rig.ask(kGo), "");
    rig.run(Seconds(1.0));
    EXPECT_THAT(rig.ask(request::SetGain{.gain = Gain::Damping, .value = 9000.0}), HasSubstr("The mount moves"));
    EXPECT_THAT(rig.obstacle(Action::SetAzimuthGains), HasSubstr("The mount moves"));
    rig.run(Seconds(20.0));
    ASSERT_EQ(rig.set(Gain::Stiffness, 0.8), "");
    EXPECT_THAT(rig.obstacle(Action::ReadDrives), HasSubstr("gains are being read or written"));
    ASSERT_TRUE(rig.settles());
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.control.status().state, StationState::Hold);
    EXPECT_TRUE(rig.drives().azimuth.gains.onTrial);
    EXPECT_TRUE(rig.logSays("in force until a power cycle: servo.pid_position.kp"));
    EXPECT_NEAR(rig.pair.truth(Axis::Azimuth).angle.degrees(), 30.0, 0.2);

    EXPECT_THAT(rig.set(Gain::EncoderFilter, 0.5), HasSubstr("switched on"));
    EXPECT_THAT(rig.ask(request::StoreGains{}), HasSubstr("switched on"));
    EXPECT_THAT(rig.obstacle(Action::SetAzimuthFilter), HasSubstr("switched on"));
}

TEST(DriveCare, GainsAreStoredWhileTheDrivesAreOff)
{
    GainsAtRest rig;
    ASSERT_TRUE(rig.read());
    EXPECT_THAT(rig.refusal(request::StoreGains{}), HasSubstr("No gains are on trial"));
    EXPECT_THAT(rig.refusal(request::PutGainsBack{}), HasSubstr("as they were found"));
    ASSERT_EQ(rig.set(Gain::InertiaFeedforward, 1.1), "");
    ASSERT_TRUE(rig.settles());
    ASSERT_EQ(rig.refusal(request::StoreGains{}), "");
    ASSERT_EQ(rig.ask(request::StoreGains{}), "");
    ASSERT_TRUE(rig.settles());
    EXPECT_FALSE(rig.drives().azimuth.gains.onTrial);
    EXPECT_TRUE(rig.logSays("are stored in its drive"));
}

// The count of the encoder begins anew, so nobody knows on which wrap the axis is until it is judged.
TEST(DriveCare, GainsOfTheFilterMakeTheWrapUnknown)
{
    GainsAtRest rig;
    ASSERT_TRUE(rig.read());
    ASSERT_TRUE(rig.control.status().azimuth.turnKnown);
    ASSERT_EQ(rig.set(Gain::EncoderFilter, 0.5), "");
    bool unknown = false;
    for (int i = 0; i < 200; ++i) {
        rig.tick();
        unknown = unknown || !rig.control.status().azimuth.turnKnown;
    }
    EXPECT_TRUE(unknown);
    EXPECT_DOUBLE_EQ(rig.pair.drive(Axis::Azimuth).driveConfig().motorPosition.pllFilter, 200.0);
    EXPECT_TRUE(rig.logSays("counts anew with the other encoder filter"));
}

// Story: Fix stores all that is in force, so gains that were only being tried would have stayed for ever.
// REQ-AXES-961: Fix is refused while gains are on trial.
TEST(DriveCare, GainsOnTrialAreNotStoredByFix)
{
    GainsAtRest rig(dampingElevation());
    ASSERT_TRUE(rig.read());
    ASSERT_EQ(rig.refusal(request::FixDrives{}), "");
    ASSERT_EQ(rig.set(Gain::Damping, 1.2), "");
    ASSERT_TRUE(rig.settles());
    EXPECT_THAT(rig.refusal(request::FixDrives{}), HasSubstr("New gains are on trial"));
    ASSERT_EQ(rig.ask(request::PutGainsBack{}), "");
    ASSERT_TRUE(rig.settles());
    EXPECT_EQ(rig.refusal(request::FixDrives{}), "");
}

// Connects only the board of this axis.
void connectAlone(CareRig& rig, Axis axis)
{
    for (const Axis one : kAxes) {
        rig.pair.setFitted(one, one == axis);
    }
    rig.run(Seconds(5.0));
}

// REQ-SURVEY-955: Two boards from the factory get their ids one after the other by requests of the operator, who
// confirms the board by its UUID. The station permits it only while one board is connected, no drive is on and nothing
// moves. Meanwhile nothing else is done to the drives.
TEST(BoardDesk, TwoBoardsFromTheFactoryGetTheirIds)
{
    CareRig rig(sim::factoryPair());
    rig.run(Seconds(5.0));
    ASSERT_FALSE(rig.drives().boards.empty());
    EXPECT_TRUE(rig.drives().boards.front().shared);
    EXPECT_THAT(rig.obstacle(Action::AssignElevationBoard), HasSubstr("Two boards have the id 1"));

    connectAlone(rig, Axis::Elevation);
    ASSERT_EQ(rig.drives().boards.size(), 1u);
    EXPECT_FALSE(rig.drives().boards.front().shared);
    EXPECT_THAT(rig.obstacle(Action::AssignAzimuthBoard), HasSubstr("has the id 1 of the azimuth already"));
    EXPECT_EQ(rig.obstacle(Action::AssignElevationBoard), "");
    const request::AssignBoard assign{.board = rig.drives().boards.front().uuid, .axis = Axis::Elevation};
    EXPECT_EQ(rig.refusal(assign), "");
    ASSERT_EQ(rig.ask(assign), "");
    EXPECT_TRUE(rig.drives().boardWork.running);
    EXPECT_THAT(rig.refusal(request::FixDrives{}), HasSubstr("A board is being changed"));
    EXPECT_THAT(rig.ask(kGo), Not(""));
    rig.run(Seconds(6.0));
    EXPECT_FALSE(rig.drives().boardWork.running);
    EXPECT_FALSE(rig.drives().boardWork.failed) << rig.drives().boardWork.text.toStdString();
    EXPECT_THAT(rig.drives().boardWork.text.toStdString(), HasSubstr("has the id 2 now"));

    rig.pair.setFitted(Axis::Azimuth, true);
    ASSERT_TRUE(rig.reaches(SurveyState::Done));
    ASSERT_EQ(rig.drives().boards.size(), 2u);
    EXPECT_EQ(rig.drives().boards[0].id, 1);
    EXPECT_EQ(rig.drives().boards[1].id, 2);
    EXPECT_FALSE(rig.drives().boards[1].shared);
}

// REQ-SURVEY-955
TEST(BoardDesk, AnotherBoardThanTheConfirmedOneIsRefused)
{
    CareRig rig(sim::factoryPair());
    connectAlone(rig, Axis::Elevation);
    const request::AssignBoard assign{.board = rig.drives().boards.front().uuid, .axis = Axis::Elevation};
    connectAlone(rig, Axis::Azimuth);
    EXPECT_THAT(rig.refusal(assign), HasSubstr("Another board is connected"));
}

// REQ-SURVEY-956: A gear ratio that differs from the profile is written on the request of the operator, with what else
// depends on it said before. Never while a drive is on.
TEST(BoardDesk, TheGearOfAFactoryBoardIsWrittenAndRead)
{
    sim::PairSettings settings = sim::factoryPair();
    settings.elevation.config.id = 2;
    CareRig rig(settings);
    profile::Profile geared;
    geared.elevation.geometry.gearRatio = 100.0;
    rig.setProfile(geared);
    ASSERT_TRUE(rig.reaches(SurveyState::Done));
    const auto gear = rig.drives().elevation.gear;
    ASSERT_TRUE(gear);
    EXPECT_EQ(gear->found, QStringLiteral("1"));
    EXPECT_EQ(gear->wanted, QStringLiteral("0.01"));
    EXPECT_THAT(gear->effect.toStdString(), HasSubstr("10000 times"));
    EXPECT_EQ(rig.obstacle(Action::SetElevationGear), "");
    ASSERT_EQ(rig.ask(request::SetGear{.axis = Axis::Elevation}), "");
    rig.run(Seconds(6.0));
    EXPECT_FALSE(rig.drives().boardWork.failed) << rig.drives().boardWork.text.toStdString();
    ASSERT_TRUE(rig.reaches(SurveyState::Done));
    EXPECT_FALSE(rig.drives().elevation.gear) << "it is right now";
    EXPECT_NE(rig.obstacle(Action::SetElevationGear), "");
    EXPECT_EQ(rig.pair.drive(Axis::Azimuth).driveConfig().motorPosition.rotorToOutputRatio, 1.0);
}

// REQ-SURVEY-956
TEST(BoardDesk, NoGearIsWrittenWhileADriveIsOn)
{
    CareRig rig;
    ASSERT_TRUE(rig.endsItsSurvey());
    ASSERT_EQ(rig.ask(kGo), "");
    rig.run(Seconds(1.0));
    EXPECT_THAT(rig.obstacle(Action::SetAzimuthGear), Not(""));
    EXPECT_THAT(rig.ask(request::SetGear{.axis = Axis::Azimuth}), Not(""));
    EXPECT_THAT(rig.ask(request::AssignBoard{.board = {}, .axis = Axis::Azimuth}), Not(""));
}

}  // namespace
}  // namespace boresight
