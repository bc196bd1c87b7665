// SPDX-License-Identifier: GPL-3.0-or-later
// The permissions that the station publishes for each action agree with its answers to the requests.
#include "tests/core/control/station_rig.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <ostream>
#include <string>

namespace boresight {
namespace {

using Situation = void (*)(StationRig&);

void nobodyAnswers(StationRig& rig)
{
    rig.azimuth.silent = rig.elevation.silent = true;
    rig.run(Seconds(0.5));
}

void standing(StationRig& rig)
{
    ASSERT_TRUE(rig.holdAt({100_deg, 30_deg}));
}

void wound(StationRig& rig)
{
    ASSERT_TRUE(rig.holdAt({300_deg, 30_deg}));
}

void moving(StationRig& rig)
{
    standing(rig);
    ASSERT_TRUE(rig.ask(request::PointAxes{{200_deg, 30_deg}}));
    rig.run(Seconds(2.0));
}

void proving(StationRig& rig)
{
    standing(rig);
    ASSERT_TRUE(rig.ask(request::ProveCrashStop{2_deg_s}));
    rig.run(Seconds(0.2));
}

void braking(StationRig& rig)
{
    moving(rig);
    ASSERT_TRUE(rig.ask(request::Stop{}));
    rig.run(Seconds(0.2));
}

void stopped(StationRig& rig)
{
    standing(rig);
    ASSERT_TRUE(rig.ask(request::Stop{}));
    rig.run(Seconds(0.5));
}

void faulted(StationRig& rig)
{
    standing(rig);
    rig.azimuth.mode = moteus::Mode::Fault;
    rig.azimuth.fault = 38;
    rig.run(Seconds(0.5));
}

void released(StationRig& rig)
{
    standing(rig);
    ASSERT_TRUE(rig.ask(request::ReleaseBus{}));
    rig.run(Seconds(0.5));
}

void switchedOff(StationRig& rig)
{
    standing(rig);
    ASSERT_TRUE(rig.ask(request::SwitchOff{}));
    rig.run(Seconds(0.5));
}

void unfit(StationRig& rig)
{
    standing(rig);
    rig.mount.setInterlock(
        failure(ErrorCode::Refused, QStringLiteral("Boresight is reading the drives. Wait a moment.")));
}

void unconfirmed(StationRig& rig)
{
    standing(rig);
    rig.profile.mount.directions = profile::Directions::Unconfirmed;
    rig.setProfile(rig.profile);
}

void homeBelowTheHorizon(StationRig& rig)
{
    standing(rig);
    pointing::Region region = rig.profile.limits;
    region.horizon = {{0_deg, 10_deg}, {180_deg, 10_deg}};
    rig.profile.park.elevation = 20_deg;  // otherwise the profile is invalid
    rig.draw(region);
}

void turnUnknown(StationRig& rig)
{
    standing(rig);
    rig.mount.driveRestarted(Axis::Azimuth);
}

void turnAsked(StationRig& rig)
{
    turnUnknown(rig);
    auto restarted = rig.factsOf(Axis::Azimuth);
    restarted.bootedAt = rig.clock.now();
    rig.azimuth.home = moteus::HomeState::Rotor;
    rig.learn(Axis::Azimuth, restarted);
    rig.run(Seconds(1.5));
    ASSERT_TRUE(rig.control.status().drives->azimuth.turnQuestion);
}

// One of the possible positions that the drive reports, inside the travel of the axis.
Angle placeOf(const StationRig& rig, Axis axis)
{
    const DrivesStatus drives = *rig.control.status().drives;
    const auto& question = (axis == Axis::Azimuth ? drives.azimuth : drives.elevation).turnQuestion;
    return question && !question->candidates.empty() ? question->candidates[question->candidates.size() / 2] : Angle{};
}

AxisRates jogging(JogDirection direction, AngularRate rate)
{
    switch (direction) {
        case JogDirection::Up:
            return {.elevation = rate};
        case JogDirection::Down:
            return {.elevation = -rate};
        case JogDirection::Left:
            return {.azimuth = -rate};
        case JogDirection::Right:
            break;
    }
    return {.azimuth = rate};
}

// The request that the screen sends for this action.
Request requestOf(Action action, const StationRig& rig)
{
    const auto jog = [&](JogDirection direction) {
        return request::Jog{
            jogging(direction, std::min(rig.control.status().permissions.fastestJog, rig.profile.jog.slow))};
    };
    switch (action) {
        case Action::Park:
            return request::Park{};
        case Action::Home:
            return request::Home{};
        case Action::Horizon:
            return request::Horizon{};
        case Action::Unwind:
            return request::Unwind{};
        case Action::JogUp:
            return jog(JogDirection::Up);
        case Action::JogDown:
            return jog(JogDirection::Down);
        case Action::JogLeft:
            return jog(JogDirection::Left);
        case Action::JogRight:
            return jog(JogDirection::Right);
        case Action::StepRight:
            return request::Step{.azimuth = 1_deg, .elevation = {}};
        case Action::ReadDrives:
            return request::ReadDrives{};
        case Action::FixDrives:
            return request::FixDrives{};
        case Action::SwitchOff:
            return request::SwitchOff{};
        case Action::SwitchOffAzimuth:
            return request::SwitchOff{Axis::Azimuth};
        case Action::SwitchOffElevation:
            return request::SwitchOff{Axis::Elevation};
        case Action::ReleaseBus:
            return request::ReleaseBus{};
        case Action::ProveCrashStop:
            return request::ProveCrashStop{2_deg_s};
        case Action::Reconnect:
            return request::Reconnect{rig.profile};
        case Action::Rearm:
            return request::Rearm{};
        case Action::ResetStop:
            return request::ResetStop{};
        case Action::TakeAuthority:
            return request::TakeAuthority{};
        case Action::GiveAuthority:
            return request::GiveAuthority{};
        case Action::ChooseAzimuthTurn:
            return request::ChooseTurn{Axis::Azimuth, placeOf(rig, Axis::Azimuth)};
        case Action::ChooseElevationTurn:
            return request::ChooseTurn{Axis::Elevation, placeOf(rig, Axis::Elevation)};
        case Action::TakeBus:
            return request::TakeBus{};
        case Action::TypeLine:
            return request::TypeLine{"C2"};
        case Action::EndProof:
            return request::EndProof{};
        case Action::ReadAzimuthGains:
            return request::ReadGains{Axis::Azimuth};
        case Action::SetElevationGains:
            return request::SetGain{Axis::Elevation, Gain::Damping, 1.0};
        case Action::SetAzimuthFilter:
            return request::SetGain{Axis::Azimuth, Gain::EncoderFilter, 100.0};
        case Action::PutElevationGainsBack:
            return request::PutGainsBack{Axis::Elevation};
        case Action::StoreAzimuthGains:
            return request::StoreGains{Axis::Azimuth};
        default:
            return request::PointAxes{{110_deg, 40_deg}};
    }
}

constexpr std::array kAsked{Action::Point,
                            Action::Park,
                            Action::Home,
                            Action::Horizon,
                            Action::Unwind,
                            Action::JogUp,
                            Action::JogDown,
                            Action::JogLeft,
                            Action::JogRight,
                            Action::StepRight,
                            Action::ReadDrives,
                            Action::FixDrives,
                            Action::SwitchOff,
                            Action::SwitchOffAzimuth,
                            Action::SwitchOffElevation,
                            Action::ReleaseBus,
                            Action::TakeBus,
                            Action::TypeLine,
                            Action::Reconnect,
                            Action::ProveCrashStop,
                            Action::EndProof,
                            Action::ReadAzimuthGains,
                            Action::SetElevationGains,
                            Action::SetAzimuthFilter,
                            Action::PutElevationGainsBack,
                            Action::StoreAzimuthGains,
                            Action::Rearm,
                            Action::ResetStop,
                            Action::TakeAuthority,
                            Action::GiveAuthority,
                            Action::ChooseAzimuthTurn,
                            Action::ChooseElevationTurn};

struct Scene
{
    const char* name;
    Situation situation;
};

void PrintTo(const Scene& one, std::ostream* out)
{
    *out << one.name;
}

class PermissionsIn : public ::testing::TestWithParam<Scene>
{};

// REQ-CONTROL-921: The check that judges a request also decides whether the operator's button is offered, and gives the
// same reason. This holds for motions, drives, bus, crash-stop test, re-arm, reset of STOP, control authority and the
// answer about a wrap. The answer may also name another place where the mount could go.
TEST_P(PermissionsIn, AnActionIsAnsweredAsItWasPublished)
{
    for (const Action action : kAsked) {
        StationRig rig;
        GetParam().situation(rig);
        const std::string published = rig.control.status().permissions.reason(action).toStdString();
        const Result<> answer = rig.ask(requestOf(action, rig));
        const std::string told = answer ? std::string() : textOf(answer.error());
        EXPECT_EQ(published, told.substr(0, told.find(". Nearest allowed"))) << static_cast<int>(action);
    }
}

TEST_P(PermissionsIn, HoldIsNeverRefused)
{
    StationRig rig;
    GetParam().situation(rig);
    EXPECT_TRUE(rig.ask(request::Hold{}));
}

INSTANTIATE_TEST_SUITE_P(Permissions, PermissionsIn,
                         ::testing::Values(Scene{"nobodyAnswers", nobodyAnswers}, Scene{"standing", standing},
                                           Scene{"wound", wound}, Scene{"moving", moving}, Scene{"proving", proving},
                                           Scene{"braking", braking}, Scene{"stopped", stopped},
                                           Scene{"faulted", faulted}, Scene{"released", released},
                                           Scene{"switchedOff", switchedOff}, Scene{"unfit", unfit},
                                           Scene{"unconfirmed", unconfirmed},
                                           Scene{"homeBelowTheHorizon", homeBelowTheHorizon},
                                           Scene{"turnUnknown", turnUnknown}, Scene{"turnAsked", turnAsked}),
                         [](const auto& one) { return std::string(one.param.name); });

// The situations above show each of these actions both allowed and refused.
TEST(Permissions, WhatBringsTheMountBackIsOfferedWhereItCanAct)
{
    const auto may = [](Situation situation) {
        StationRig rig;
        situation(rig);
        return rig.control.status().permissions;
    };
    EXPECT_TRUE(may(faulted).allows(Action::Rearm));
    EXPECT_FALSE(may(standing).allows(Action::Rearm));
    EXPECT_TRUE(may(stopped).allows(Action::ResetStop));
    EXPECT_EQ(may(braking).reason(Action::ResetStop),
              QStringLiteral("The mount is still braking. Reset STOP when it stands still."));
    EXPECT_EQ(may(moving).reason(Action::ResetStop), QStringLiteral("STOP is not latched"));
    EXPECT_EQ(may(stopped).reason(Action::GiveAuthority), QStringLiteral("STOP is latched. Reset STOP first."));
    EXPECT_TRUE(may(standing).allows(Action::GiveAuthority));
    EXPECT_TRUE(may(turnAsked).allows(Action::ChooseAzimuthTurn));
    EXPECT_FALSE(may(turnAsked).allows(Action::ChooseElevationTurn)) << "nobody asks about it";
    EXPECT_TRUE(may(released).allows(Action::TakeBus));
    EXPECT_FALSE(may(standing).allows(Action::TakeBus));
    EXPECT_TRUE(may(proving).allows(Action::EndProof));
    EXPECT_FALSE(may(standing).allows(Action::EndProof));
}

TEST(Permissions, ATrimIsClearedWhereThereIsOneAndTheRequestIsNeverRefused)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(50.0, 30.0, Seconds(1.0)));
    EXPECT_EQ(rig.control.status().permissions.reason(Action::ClearTrim), QStringLiteral("The target has no trim."));
    EXPECT_TRUE(rig.ask(request::ClearTrim{}));
    ASSERT_TRUE(rig.ask(request::Nudge{.azimuth = 0.5_deg}));
    EXPECT_TRUE(rig.control.status().permissions.allows(Action::ClearTrim));
    ASSERT_TRUE(rig.ask(request::ClearTrim{}));
    EXPECT_FALSE(rig.control.status().permissions.allows(Action::ClearTrim));
}

TEST(Permissions, OfAStationThatNobodyKnowsForbidEverything)
{
    const StationStatus status;
    for (int action = 0; action < static_cast<int>(Action::Count); ++action) {
        EXPECT_EQ(status.permissions.reason(static_cast<Action>(action)),
                  QStringLiteral("The station has not reported yet."))
            << action;
    }
}

TEST(Permissions, ThereIsNoWayOnAtTheEndOfTheTravel)
{
    StationRig rig;
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.ask(request::PointAxes{{450_deg, 90_deg}}));
    rig.settle();
    const Permissions may = rig.control.status().permissions;
    EXPECT_EQ(may.reason(Action::JogRight), QStringLiteral("at the upper limit 450.0°"));
    EXPECT_EQ(may.reason(Action::StepUp), QStringLiteral("at the upper limit 90.0°"));
    EXPECT_TRUE(may.allows(Action::JogLeft));
    EXPECT_TRUE(may.allows(Action::StepDown));
}

TEST(Permissions, AJogIsSlowWhereSomebodyMustWatch)
{
    StationRig rig;
    standing(rig);
    const profile::JogSettings jog = rig.profile.jog;
    EXPECT_EQ(rig.control.status().permissions.fastestJog, jog.fast);
    rig.profile.mount.directions = profile::Directions::Unconfirmed;
    rig.setProfile(rig.profile);
    EXPECT_EQ(rig.control.status().permissions.fastestJog, std::min(jog.fast, profile::kFastestUnconfirmed));
    rig.mount.driveRestarted(Axis::Azimuth);
    EXPECT_EQ(rig.control.status().permissions.fastestJog, std::min(jog.slow, jog.unwind));
}

TEST(Permissions, AnAngleIsSetOfAnAxisThatStandsAndIsSeen)
{
    StationRig rig;
    standing(rig);
    rig.run(Seconds(1.1));
    EXPECT_TRUE(rig.control.status().permissions.allows(Action::SetAzimuth));
    rig.elevation.silent = true;
    rig.run(Seconds(1.5));
    EXPECT_TRUE(rig.control.status().permissions.allows(Action::SetAzimuth));
    EXPECT_EQ(rig.control.status().permissions.reason(Action::SetElevation),
              QStringLiteral("no fresh position from the elevation drive"));
    rig.mount.driveRestarted(Axis::Azimuth);
    EXPECT_FALSE(rig.control.status().permissions.allows(Action::SetAzimuth)) << "nobody knows where it stands";
}

// Story: setting the zero of an axis was offered while somebody turned the axis by hand.
TEST(Permissions, AnAngleIsNotSetOfAnAxisThatIsTurnedByHand)
{
    StationRig rig;
    rig.run(Seconds(1.1));
    for (int i = 0; i < 10; ++i) {
        rig.azimuth.position += 0.0001;
        rig.tick();
    }
    EXPECT_EQ(rig.control.status().permissions.reason(Action::SetAzimuth),
              QStringLiteral("The mount moves. Stop it first."));
    rig.run(Seconds(1.1));
    EXPECT_TRUE(rig.control.status().permissions.allows(Action::SetAzimuth));
}

// Story: behind a low gear ratio the noise of the velocity alone, here 3.6°/s, refused the angle from time to time.
TEST(Permissions, AnAngleIsSetWhereOnlyTheReportedRateIsNotZero)
{
    StationRig rig;
    rig.azimuth.velocity = 0.01;
    rig.run(Seconds(1.1));
    EXPECT_TRUE(rig.control.status().permissions.allows(Action::SetAzimuth));
}

// Story: the Hold button was grey while the crash-stop test moved the mount.
TEST(Permissions, HoldIsOfferedWhileSomethingMovesTheMountAndEndsIt)
{
    for (const Situation situation : {moving, proving}) {
        StationRig rig;
        situation(rig);
        EXPECT_TRUE(rig.control.status().permissions.allows(Action::Hold));
        ASSERT_TRUE(rig.ask(request::Hold{}));
        rig.run(Seconds(3.0));
        EXPECT_EQ(rig.state(), StationState::Hold);
        EXPECT_FALSE(rig.control.status().drives->proofRunning);
    }
}

TEST(Permissions, HoldIsNotOfferedWhereNothingIsLeftToHold)
{
    for (const Situation situation : {nobodyAnswers, stopped, faulted, released}) {
        StationRig rig;
        situation(rig);
        const Permissions may = rig.control.status().permissions;
        EXPECT_EQ(may.reason(Action::Hold), may.reason(Action::Move));
        EXPECT_FALSE(may.allows(Action::Hold));
    }
}

TEST(Permissions, AClientIsToldWhyControlCannotBeGivenToIt)
{
    StationRig rig;
    rig.control.clientCame(kClient, "10.0.0.7");
    rig.control.clientCame(kOtherClient, "10.0.0.8");
    rig.run(Seconds(0.2));
    const auto obstacle = [&rig](std::uint64_t id) {
        ClientStatus client{.id = id};
        rig.control.describe(client, std::nullopt);
        return client.controlObstacle.toStdString();
    };
    EXPECT_EQ(obstacle(1), "");
    ASSERT_TRUE(rig.ask(request::GiveControl{.clientId = 1}));
    EXPECT_EQ(obstacle(1), "this client has control");
    EXPECT_EQ(obstacle(2), "");
    // Story: the reason named the newest client. A client that connects later has no control before it sends a target.
    rig.profile.rotctld.control = profile::ControlRule::Last;
    rig.setProfile(rig.profile);
    EXPECT_EQ(obstacle(2), "the client that sent last has control");
    rig.profile.rotctld.control = profile::ControlRule::Locked;
    rig.profile.rotctld.lockedTo = "10.0.0.7";
    rig.setProfile(rig.profile);
    EXPECT_EQ(obstacle(2), textOf(rig.ask(request::GiveControl{.clientId = 2}).error()));
    ASSERT_TRUE(rig.ask(request::Stop{}));
    EXPECT_EQ(obstacle(2), textOf(rig.ask(request::GiveControl{.clientId = 2}).error()));
}

}  // namespace
}  // namespace boresight
