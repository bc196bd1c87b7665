// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the question about the wrap of an axis: the operator is asked if the wrap cannot be proven, and the answer is
// written into the drive. station_turn_proof_test.cpp tests the proofs.
#include "tests/core/control/station_rig.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

// The mount stands at 100° 45° and loses its power. When it is back, this axis has another board.
void exchangeBoard(StationRig& rig, Axis axis)
{
    rig.run(Seconds(0.5));
    ASSERT_TRUE(rig.ask(request::PointAxes{{100_deg, 45_deg}}));
    rig.settle();
    rig.azimuth.silent = rig.elevation.silent = true;
    rig.run(Seconds(0.5));
    rig.azimuth.mode = rig.elevation.mode = moteus::Mode::Stopped;
    rig.azimuth.silent = rig.elevation.silent = false;
    auto other = rig.factsOf(axis);
    other.uuid = QStringLiteral("b0000000-0000-0000-0000-000000000003");
    rig.learn(axis, other);
}

using moteus::HomeState;
using moteus::Register;

// The time at the beginning of a test.
UtcTime now()
{
    return fakes::ManualClock().utc();
}

// The azimuth drive has lost power: it knows its direction only within a multiple of 3.6°.
struct RestartedRig : StationRig
{
    RestartedRig()
    {
        run(Seconds(0.5));
        EXPECT_TRUE(ask(request::PointAxes{{100_deg, 45_deg}}));
        settle();
        azimuth.silent = elevation.silent = true;
        run(Seconds(0.5));
        azimuth.home = HomeState::Rotor;
        azimuth.position = std::remainder(azimuth.position, 0.01);
        azimuth.mode = elevation.mode = moteus::Mode::Stopped;
        azimuth.silent = elevation.silent = false;
        auto restarted = factsOf(Axis::Azimuth);
        restarted.bootedAt = clock.now();
        learn(Axis::Azimuth, restarted);
        run(Seconds(1.5));
        EXPECT_TRUE(ask(request::Rearm{}));
        run(Seconds(0.5));
    }

    [[nodiscard]] std::optional<TurnQuestion> question() const { return control.status().drives->azimuth.turnQuestion; }
};

TEST(StationTurns, AfterAPowerCutTheOperatorIsAsked)
{
    RestartedRig rig;
    ASSERT_TRUE(rig.question());
    EXPECT_FALSE(rig.control.status().azimuth.turnKnown);
    EXPECT_TRUE(rig.control.status().elevation.turnKnown) << "the other drive never lost power";
    EXPECT_NEAR(rig.question()->period.degrees(), 3.6, 1e-9);
    EXPECT_FALSE(rig.control.measured()) << "clients get no position";
    EXPECT_FALSE(rig.control.status().actual);
    EXPECT_EQ(rig.point(10.0, 10.0, kOperator).error().code, ErrorCode::Refused);
    EXPECT_EQ(rig.ask(request::Park{}).error().code, ErrorCode::Refused);
    EXPECT_EQ(rig.ask(request::ProveCrashStop{2_deg_s}).error().code, ErrorCode::Refused);
}

// REQ-WITNESS-40
TEST(StationTurns, ASensorOnTheAntennaSpeaksInTheQuestion)
{
    RestartedRig rig;
    ASSERT_TRUE(rig.question());
    EXPECT_EQ(rig.question()->evidence.back(), QStringLiteral("There is no sensor to compare with"));
    rig.control.setSensor(98_deg, std::nullopt);
    EXPECT_EQ(rig.question()->evidence.back(), QStringLiteral("The sensor reports 98.0°"));
    rig.control.setSensor(-1.5_deg, std::nullopt);
    EXPECT_EQ(rig.question()->evidence.back(), QStringLiteral("The sensor reports 358.5°"));
    EXPECT_FALSE(rig.control.status().azimuth.turnKnown) << "it decides nothing";

    rig.profile.pointing.azimuthOffset = 37.5_deg;
    rig.setProfile(rig.profile);
    rig.control.setSensor(98_deg, std::nullopt);
    EXPECT_EQ(rig.question()->evidence.back(), QStringLiteral("The sensor reports 60.5°")) << "as the axis counts";
}

TEST(StationTurns, OnlyTheOperatorJogsMeanwhileAndSlowly)
{
    RestartedRig rig;
    EXPECT_FALSE(rig.ask(request::Jog{{.azimuth = 2_deg_s}}, kClient));
    EXPECT_FALSE(rig.ask(request::Move{{.azimuth = 1_deg_s}}, kClient));
    EXPECT_FALSE(rig.ask(request::Jog{{.azimuth = 3_deg_s}}));
    for (int i = 0; i < 25; ++i) {
        ASSERT_TRUE(rig.ask(request::Jog{{.azimuth = -1_deg_s}}));
        rig.run(Seconds(0.1));
    }
    EXPECT_NEAR(rig.question()->movedSince.degrees(), -2.5, 0.3);
    // The drive's own bounds stay in force. Its count begins in the middle of the travel, where the bounds leave room.
    EXPECT_FALSE(rig.azimuth.seen.back().fields.contains(Register::CommandIgnorePositionBounds));
    EXPECT_NEAR(rig.azimuthDegrees(), 180.0, 5.0) << "the middle of the travel";
    EXPECT_FALSE(rig.mount.journal().turns[0]) << "jogged, the axis is not where the journal says";
}

// REQ-CONTROL-1410: Control is not handed back to the clients while Boresight asks for the wrap of an axis. The refusal
// names the axis. After the answer about the wrap control can be handed back again.
TEST(StationTurns, ControlIsHandedBackOnlyAfterTheAnswer)
{
    RestartedRig rig;
    ASSERT_TRUE(rig.question());
    const Result<> refused = rig.ask(request::GiveAuthority{});
    ASSERT_FALSE(refused);
    EXPECT_EQ(textOf(refused.error()),
              "The cable wrap of the azimuth drive is unknown. Enter the position of the axis. Only slow jog works.");
    ASSERT_TRUE(rig.ask(request::ChooseTurn{Axis::Azimuth, 100_deg}));
    rig.run(Seconds(3.0));
    ASSERT_FALSE(rig.question());
    EXPECT_TRUE(rig.ask(request::GiveAuthority{}));
}

// REQ-CONTROL-923: If the board of an axis was replaced, its wrap is unknown. The mount goes to no target until the
// operator has entered the position of the axis. Only the operator jogs the axis, slowly, and only after the drive
// check has read the safety settings of the new board and found them safe.
TEST(StationTurns, AnExchangedBoardIsOnlyJoggedSlowlyAndNotBeforeItWasChecked)
{
    StationRig rig;
    ASSERT_NO_FATAL_FAILURE(exchangeBoard(rig, Axis::Azimuth));
    rig.mount.setInterlock(failure(ErrorCode::Refused, QStringLiteral("The drive check has not run yet.")));
    rig.run(Seconds(1.5));
    ASSERT_TRUE(rig.ask(request::Rearm{}));
    rig.run(Seconds(0.5));
    ASSERT_TRUE(rig.control.isTurnAsked(Axis::Azimuth));
    EXPECT_FALSE(rig.ask(request::Jog{{.azimuth = 1_deg_s}})) << "nobody knows its safety settings";
    rig.mount.setInterlock({});
    EXPECT_FALSE(rig.point(10.0, 10.0, kOperator));
    EXPECT_FALSE(rig.ask(request::Jog{{.azimuth = 1_deg_s}}, kClient));
    EXPECT_FALSE(rig.ask(request::Jog{{.azimuth = 3_deg_s}}));
    EXPECT_TRUE(rig.ask(request::Jog{{.azimuth = 1_deg_s}})) << "to bring the cable where it can be judged";
}

// Story: the refusal named the cable wrap of the elevation drive. The elevation has no cable.
// REQ-CONTROL-1410
TEST(StationTurns, OfTheElevationThePositionIsUnknown)
{
    StationRig rig;
    ASSERT_NO_FATAL_FAILURE(exchangeBoard(rig, Axis::Elevation));
    rig.run(Seconds(1.5));
    ASSERT_TRUE(rig.ask(request::Rearm{}));
    rig.run(Seconds(0.5));
    ASSERT_TRUE(rig.control.isTurnAsked(Axis::Elevation));
    const Result<> refused = rig.ask(request::GiveAuthority{});
    ASSERT_FALSE(refused);
    EXPECT_EQ(textOf(refused.error()),
              "The position of the elevation drive is unknown. Enter the position of the axis. Only slow jog works.");
}

TEST(StationTurns, TheAnswerIsWrittenIntoTheDriveAndThePlaceIsKept)
{
    RestartedRig rig;
    EXPECT_FALSE(rig.ask(request::ChooseTurn{Axis::Azimuth, 100_deg}, kClient));
    EXPECT_FALSE(rig.ask(request::ChooseTurn{Axis::Elevation, 45_deg})) << "nobody has asked";
    ASSERT_TRUE(rig.ask(request::ChooseTurn{Axis::Azimuth, 100.5_deg}));
    rig.run(Seconds(0.3));
    EXPECT_EQ(rig.azimuth.home, HomeState::Output);
    EXPECT_NEAR(rig.azimuthDegrees(), 100.0, 1e-4) << "the phase of the encoder is kept";
    EXPECT_FALSE(rig.question());
    EXPECT_TRUE(rig.control.measured());
    ASSERT_TRUE(rig.point(110.0, 45.0, kOperator));
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 110.0, 0.001);
    EXPECT_FALSE(rig.azimuth.seen.back().fields.contains(Register::CommandIgnorePositionBounds));
}

TEST(StationTurns, AHeldAxisIsHeldWhileItTakesItsPlace)
{
    RestartedRig rig;
    ASSERT_TRUE(rig.ask(request::Jog{{.azimuth = 1_deg_s}}));
    rig.run(Seconds(2.0));  // the jog ends without its keep-alive, and both axes are held
    ASSERT_EQ(rig.azimuth.mode, moteus::Mode::Position);
    rig.azimuth.seen.clear();
    const double before = rig.azimuth.position;
    ASSERT_TRUE(rig.ask(request::ChooseTurn{Axis::Azimuth, 100_deg}));
    rig.run(Seconds(1.0));
    EXPECT_NEAR(std::remainder(rig.azimuth.position - before, 0.01), 0.0, 1e-6) << "the axis has not moved";
    EXPECT_GT(rig.azimuth.seen.size(), 40U) << "fed throughout";
    EXPECT_EQ(rig.azimuth.mode, moteus::Mode::Position);
    EXPECT_TRUE(rig.control.status().azimuth.turnKnown);
}

TEST(StationTurns, WhatTheDriveContradictsIsNotTaken)
{
    profile::Profile profile;
    StationRig rig(profile);
    rig.azimuth.home = HomeState::Rotor;
    auto facts = rig.factsOf(Axis::Azimuth);
    facts.outputEncoder = true;  // the drive knows the direction: only the 360° wraps are in doubt
    facts.bootedAt = rig.clock.now();
    rig.run(Seconds(0.5));
    ASSERT_TRUE(rig.ask(request::PointAxes{{360_deg, 45_deg}}));
    rig.settle();
    rig.azimuth.silent = true;
    rig.run(Seconds(0.5));
    facts.bootedAt = rig.clock.now();
    rig.learn(Axis::Azimuth, facts);
    rig.azimuth.position = 0.0;
    rig.azimuth.silent = false;
    rig.run(Seconds(1.5));
    const auto question = rig.control.status().drives->azimuth.turnQuestion;
    ASSERT_TRUE(question);
    EXPECT_EQ(question->candidates.size(), 2U) << "0° and 360°";
    const auto refused = rig.ask(request::ChooseTurn{Axis::Azimuth, 100_deg});
    ASSERT_FALSE(refused);
    EXPECT_NE(textOf(refused.error()).find("contradicts"), std::string::npos) << textOf(refused.error());
}

// The elevation coasted beyond its travel (0…90°) without power, and there is no journal.
struct CoastedRig : StationRig
{
    explicit CoastedRig(double place, std::optional<Angle> told = std::nullopt)
        : StationRig(
              profile::Profile{},
              {.problem = QStringLiteral("The journal file is missing."), .standingAt = {0_deg, told}, .looked = now()})
    {
        elevation.home = HomeState::Rotor;
        elevation.position = profile.elevation.geometry.toMotor(Angle::fromDegrees(place)).turns();
        run(Seconds(0.5));
    }

    [[nodiscard]] std::optional<TurnQuestion> question() const
    {
        return control.status().drives->elevation.turnQuestion;
    }

    [[nodiscard]] bool mayBeAt(double place) const
    {
        return std::ranges::any_of(question().value().candidates,
                                   [&](Angle one) { return std::abs(one.degrees() - place) < 0.01; });
    }
};

// Story: the question said "26 places from 0.2° to 90.2° are possible". The true position, -7°, was refused as
// contradicting the drive.
TEST(StationTurns, BeyondTheTravelTheTruePlaceCanBeTold)
{
    CoastedRig asked(-7.0);
    ASSERT_TRUE(asked.question());
    EXPECT_TRUE(asked.mayBeAt(-7.0));
    const CoastedRig told(-7.0, -7_deg);
    EXPECT_TRUE(told.control.status().elevation.turnKnown);
    EXPECT_NEAR(told.elevationDegrees(), -7.0, 1e-4);
}

// Story: the possible places were computed once and then only shifted with the motion. After jogging back none of them
// was true.
TEST(StationTurns, JoggedBackThePlacesAreThoseOfNow)
{
    CoastedRig rig(-20.0);
    ASSERT_TRUE(rig.question());
    EXPECT_FALSE(rig.mayBeAt(-20.0)) << "no stop lets it go so far";
    for (int i = 0; i < 100; ++i) {
        ASSERT_TRUE(rig.ask(request::Jog{{.elevation = 1_deg_s}}));
        rig.run(Seconds(0.1));
    }
    const double moved = rig.question()->movedSince.degrees();
    EXPECT_NEAR(moved, 10.0, 0.5);
    EXPECT_TRUE(rig.mayBeAt(-20.0 + moved));
    EXPECT_LE(rig.question()->candidates.back(), 105_deg);
    EXPECT_GE(rig.question()->candidates.front(), -15_deg);
}

// The drive reports a place at the upper end of the travel, which is shorter than 3.6°.
TEST(StationTurns, ALimitOfAnUnknownTurnBlocksNoWay)
{
    profile::Profile profile;
    profile.elevation.geometry.travel = {.min = 0_deg, .max = 3.5_deg};
    const auto waysAt = [&](StationRig& rig) {
        rig.elevation.position = profile.elevation.geometry.toMotor(3.48_deg).turns();
        rig.run(Seconds(0.5));
        EXPECT_NEAR(rig.control.status().elevation.actual->degrees(), 3.48, 1e-3);
        return rig.control.status().permissions;
    };
    StationRig known(profile);
    const Permissions before = waysAt(known);
    EXPECT_FALSE(before.allows(Action::JogUp));
    EXPECT_TRUE(before.allows(Action::JogDown)) << before.reason(Action::JogDown).toStdString();

    StationRig asked(profile, {.problem = QStringLiteral("The journal file is missing."),
                               .standingAt = {0_deg, std::nullopt},
                               .looked = now()});
    asked.elevation.home = HomeState::Rotor;
    const Permissions may = waysAt(asked);
    ASSERT_TRUE(asked.control.status().drives->elevation.turnQuestion);
    EXPECT_TRUE(may.allows(Action::JogUp)) << may.reason(Action::JogUp).toStdString();
    EXPECT_TRUE(may.allows(Action::JogDown)) << may.reason(Action::JogDown).toStdString();
}

// Story: a drive that held was set to a position beyond its own bounds. It clamped to the bound without a ramp and
// yanked the axis.
TEST(StationTurns, BeyondItsBoundsADriveIsToldItsPlaceOnlyWhenItIsOff)
{
    CoastedRig rig(-7.0);
    ASSERT_TRUE(rig.ask(request::Jog{{.elevation = 0.1_deg_s}}));
    rig.run(Seconds(2.0));
    ASSERT_EQ(rig.elevation.mode, moteus::Mode::Position);
    const request::ChooseTurn answer{Axis::Elevation, -7_deg};
    const Result<> held = rig.ask(answer);
    ASSERT_FALSE(held);
    EXPECT_NE(textOf(held.error()).find("switch the drives off first"), std::string::npos) << textOf(held.error());
    ASSERT_TRUE(rig.ask(request::SwitchOff{}));
    rig.run(Seconds(0.3));
    rig.elevation.mode = moteus::Mode::PositionTimeout;
    rig.run(Seconds(0.1));
    EXPECT_FALSE(rig.ask(answer)) << "no frame could tell it to ignore its bounds";
    rig.elevation.mode = moteus::Mode::Stopped;
    rig.run(Seconds(0.1));
    ASSERT_TRUE(rig.ask(answer));
    rig.run(Seconds(0.5));
    EXPECT_TRUE(rig.control.status().elevation.turnKnown);
    ASSERT_TRUE(rig.ask(request::Jog{{.elevation = 0.1_deg_s}}));
    rig.run(Seconds(0.3));
    EXPECT_TRUE(rig.elevation.seen.back().fields.contains(Register::CommandIgnorePositionBounds)) << "let back inside";
}

// A drive that knows nothing about its direction: any angle may be entered.
struct LostRig : StationRig
{
    explicit LostRig(std::optional<Angle> told = std::nullopt)
        : StationRig(profile::Profile{}, {.problem = QStringLiteral("The journal file is missing."),
                                          .standingAt = {told, 10_deg},
                                          .looked = now()})
    {
        azimuth.home = HomeState::Relative;
        run(Seconds(0.5));
    }
    [[nodiscard]] std::optional<TurnQuestion> question() const { return control.status().drives->azimuth.turnQuestion; }
};

// Story: the operator entered "--standing-at 4050,10" instead of 405. The next target ran through the end of the cable
// into the mechanical stop.
// REQ-AXES-15a: A position that is entered in the window or with `--standing-at` is refused if it is more than 15°
// outside the travel. (An axis without torque coasts less far.) Boresight keeps asking for the wrap, and a refused
// position from the command line is an alarm. A position from the command line counts once, for ten minutes after the
// operator looked at the mount, also across a restart. The journal keeps the time of the last one that was used.
TEST(StationTurns, APlaceFarOutsideTheTravelIsRefused)
{
    LostRig rig;
    ASSERT_TRUE(rig.question());
    ASSERT_TRUE(rig.question()->candidates.empty());
    for (const Angle far : {4050_deg, 466_deg, -106_deg}) {
        const Result<> refused = rig.ask(request::ChooseTurn{Axis::Azimuth, far});
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code, ErrorCode::OutOfRange);
        EXPECT_NE(textOf(refused.error()).find("outside the travel (-90.0° to 450.0°) by more than 15.0°"),
                  std::string::npos)
            << textOf(refused.error());
    }
    EXPECT_FALSE(rig.control.status().azimuth.turnKnown);
    EXPECT_TRUE(rig.ask(request::ChooseTurn{Axis::Azimuth, 405_deg}));
}

// REQ-AXES-15a
TEST(StationTurns, APlaceOfTheCommandLineFarOutsideTheTravelIsAnAlarmAndTheWrapStaysAsked)
{
    LostRig rig(4050_deg);
    ASSERT_TRUE(rig.question());
    const auto alarms = rig.control.status().alarms;
    const auto told = std::ranges::find_if(alarms, [](const Alarm& alarm) {
        return alarm.what.contains(QStringLiteral("4050.0° is outside the travel"));
    });
    ASSERT_NE(told, alarms.end());
    EXPECT_EQ(told->severity, Severity::Warning);
    ASSERT_TRUE(rig.ask(request::ChooseTurn{Axis::Azimuth, 403.2_deg}));
    rig.run(Seconds(0.5));
    const auto after = rig.control.status().alarms;
    EXPECT_TRUE(std::ranges::none_of(after, [](const Alarm& alarm) { return alarm.active; }));
}

// An axis that was pushed beyond the travel, or entered there, by more than the bounds of the drives allow.
struct OutsideRig : StationRig
{
    OutsideRig() : StationRig(profile::Profile{})
    {
        run(Seconds(0.5));
        azimuth.silent = true;
        run(Seconds(0.5));
        azimuth.position = 460.0 / 360.0;
        azimuth.silent = false;
        run(Seconds(1.5));
    }
};

// REQ-CONTROL-15b: An axis can stand farther outside its travel than the bounds of its drive allow
// (`control.drive_limit_margin_deg`). Then only the operator jogs it, inwards, at `jog.unwind_deg_s` at most.
TEST(StationTurns, FarOutsideTheTravelOnlyTheOperatorJogsSlowlyAndInwards)
{
    OutsideRig rig;
    ASSERT_TRUE(rig.control.status().azimuth.turnKnown);
    const std::string why =
        "The azimuth drive stands at 460.00°, outside its travel (-90.00° to 450.00°). Jog it back "
        "slowly.";
    EXPECT_EQ(textOf(rig.point(100.0, 30.0).error()), why);
    EXPECT_EQ(textOf(rig.point(100.0, 30.0, kOperator).error()), why);
    EXPECT_EQ(textOf(rig.ask(request::Park{}).error()), why);
    EXPECT_EQ(textOf(rig.ask(request::Move{{.azimuth = -1_deg_s}}, kClient).error()), why);
    EXPECT_EQ(textOf(rig.ask(request::ProveCrashStop{2_deg_s}).error()), why);
    EXPECT_FALSE(rig.ask(request::Jog{{.azimuth = -1_deg_s}}, kClient));
    EXPECT_FALSE(rig.ask(request::Jog{{.azimuth = 0.5_deg_s}})) << "outwards";
    EXPECT_FALSE(rig.ask(request::Jog{{.azimuth = -3_deg_s}})) << "faster than jog.unwind";
    rig.run(Seconds(1.0));
    EXPECT_NEAR(rig.azimuthDegrees(), 460.0, 0.01);
    for (int i = 0; i < 100 && rig.azimuthDegrees() > 452.0; ++i) {
        ASSERT_TRUE(rig.ask(request::Jog{{.azimuth = -2_deg_s}}));
        rig.run(Seconds(0.1));
    }
    rig.run(Seconds(1.0));
    EXPECT_TRUE(rig.point(100.0, 30.0, kOperator));
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 100.0, 0.1);
}

// Story: a brown-out was too short to count as a silence, so the wrap still counted as known. The wrong position after
// it overwrote the journal.
TEST(StationTurns, ARestartThatNobodyNoticedIsSeenByTheHomeState)
{
    StationRig rig;
    rig.run(Seconds(0.5));
    ASSERT_TRUE(rig.ask(request::PointAxes{{100_deg, 45_deg}}));
    rig.settle();
    const auto before = rig.mount.journal().turns[0]->angle;
    rig.azimuth.mode = moteus::Mode::Stopped;
    rig.azimuth.home = HomeState::Rotor;
    rig.azimuth.position = std::remainder(rig.azimuth.position, 0.01);
    rig.run(Seconds(0.2));
    EXPECT_FALSE(rig.control.status().azimuth.turnKnown);
    ASSERT_TRUE(rig.mount.journal().turns[0]);
    EXPECT_NEAR(rig.mount.journal().turns[0]->angle.degrees(), before.degrees(), 0.2);
    EXPECT_FALSE(rig.point(10.0, 10.0));
}

TEST(StationTurns, AMotionEndsWhenTheTurnIsNotKnownAnyMore)
{
    StationRig rig;
    rig.run(Seconds(0.5));
    ASSERT_TRUE(rig.ask(request::PointAxes{{200_deg, 45_deg}}));
    rig.run(Seconds(3.0));
    rig.mount.driveRestarted(Axis::Azimuth);
    rig.run(Seconds(3.0));
    EXPECT_EQ(rig.state(), StationState::Standby);
    EXPECT_FALSE(rig.control.status().azimuth.target);
}

TEST(StationTurns, AJogRightAfterTheAnswerLeavesNothingHalfDone)
{
    RestartedRig rig;
    ASSERT_TRUE(rig.ask(request::ChooseTurn{Axis::Azimuth, 100_deg}));
    (void)rig.ask(request::Jog{{.elevation = 1_deg_s}});
    rig.run(Seconds(1.0));
    EXPECT_TRUE(rig.control.status().azimuth.turnKnown);
    EXPECT_NEAR(rig.azimuthDegrees(), 100.0, 1e-4);
}

// Story: the operator held the dish by hand and switched the drives off. The next target of a client switched them on
// again.
TEST(StationTurns, SwitchingOffIsNotUndoneByAClient)
{
    StationRig rig;
    rig.run(Seconds(0.5));
    ASSERT_TRUE(rig.point(100.0, 45.0));
    rig.settle();
    ASSERT_TRUE(rig.ask(request::SwitchOff{}));
    rig.run(Seconds(0.2));
    EXPECT_EQ(rig.azimuth.mode, moteus::Mode::Stopped);
    EXPECT_FALSE(rig.point(110.0, 45.0));
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.azimuth.mode, moteus::Mode::Stopped);
}

}  // namespace
}  // namespace boresight
