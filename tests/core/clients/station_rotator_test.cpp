// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clients/station_rotator.h"

#include "tests/core/control/station_rig.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace boresight {
namespace {

const rotctld::Client kRotatorGpredict{.id = 1, .address = "127.0.0.1:50000"};

struct RotatorRig : StationRig
{
    explicit RotatorRig(const profile::Profile& settings = {}) : StationRig(settings) { run(Seconds(0.2)); }

    Result<QString> pointTo(double azimuthDegrees_, double elevationDegrees_)
    {
        return rotator.pointTo(kRotatorGpredict, {.azimuth = Angle::fromDegrees(azimuthDegrees_),
                                                  .elevation = Angle::fromDegrees(elevationDegrees_)});
    }

    StationRotator rotator{control, inForce, log, clock};
};

profile::Profile withConvention(profile::AzimuthConvention convention)
{
    profile::Profile profile;
    profile.rotctld.azimuth = convention;
    return profile;
}

// Turns the axis by hand while the drive is silent. With replies it would be a jump of the encoder.
void turnByHand(RotatorRig& rig, double degrees)
{
    rig.run(Seconds(0.2));
    rig.azimuth.silent = true;
    rig.run(Seconds(0.5));
    rig.azimuth.position = degrees / 360.0;
    rig.azimuth.silent = false;
    rig.run(Seconds(0.2));
}

TEST(StationRotator, ReportsTheMeasuredAzimuthInTheConventionOfTheProfile)
{
    for (const auto& [convention, shown] : {std::pair{profile::AzimuthConvention::ZeroTo360, 5.0},
                                            std::pair{profile::AzimuthConvention::PlusMinus180, 5.0},
                                            std::pair{profile::AzimuthConvention::Continuous, 365.0}}) {
        RotatorRig rig(withConvention(convention));
        turnByHand(rig, 365.0);
        EXPECT_NEAR(rig.rotator.position(kRotatorGpredict)->azimuth.degrees(), shown, 1e-4);
    }
    RotatorRig rig(withConvention(profile::AzimuthConvention::PlusMinus180));
    turnByHand(rig, 270.0);
    EXPECT_NEAR(rig.rotator.position(kRotatorGpredict)->azimuth.degrees(), -90.0, 1e-4);
}

TEST(StationRotator, AdvertisesTheTravelAndTheWholeCircleOfTheConvention)
{
    const RotatorRig rig;
    EXPECT_EQ(rig.rotator.limits().minAzimuth, -90_deg);
    EXPECT_EQ(rig.rotator.limits().maxAzimuth, 450_deg);
    const RotatorRig half(withConvention(profile::AzimuthConvention::PlusMinus180));
    EXPECT_EQ(half.rotator.limits().minAzimuth, -180_deg);
}

TEST(StationRotator, RefuseMeansTheAdvertisedNumbers)
{
    profile::Profile profile = withConvention(profile::AzimuthConvention::Continuous);
    profile.rotctld.outsideLimits = profile::OutsideLimits::Refuse;
    RotatorRig rig(profile);
    EXPECT_TRUE(rig.pointTo(450.00001, 0.0));
    EXPECT_EQ(rig.pointTo(450.1, 0.0).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(rig.pointTo(10.0, 90.5).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(textOf(rig.pointTo(10.0, 90.5).error()), "elevation 90.50° above limit 90.00°");
}

TEST(StationRotator, MoveRunsAtAShareOfTheFastestJogRate)
{
    RotatorRig rig;
    ASSERT_TRUE(rig.rotator.move(kRotatorGpredict, rotctld::MoveDirection::Right, 50));
    rig.run(Seconds(5.0));
    EXPECT_NEAR(rig.control.status().azimuth.commandedRate->degrees(), rig.profile.jog.fast.degrees() / 2.0, 1e-6);
    EXPECT_TRUE(rig.rotator.motion().movingRight);
    ASSERT_TRUE(rig.rotator.stop(kRotatorGpredict));
    rig.run(Seconds(5.0));
    EXPECT_FALSE(rig.rotator.motion().movingRight);
}

// REQ-EASYCOMMSERVER-07: A client that turns the mount at its own rate turns at most at the fastest jog rate. The list
// of clients shows this.
TEST(StationRotator, MoveAtARateIsNoFasterThanTheJog)
{
    RotatorRig rig;
    const auto slow = rig.rotator.moveAt(kRotatorGpredict, rotctld::MoveDirection::Left, 0.25_deg_s);
    ASSERT_TRUE(slow);
    EXPECT_TRUE(slow->isEmpty());
    rig.run(Seconds(5.0));
    EXPECT_NEAR(rig.control.status().azimuth.commandedRate->degrees(), -0.25, 1e-6);
    const auto fast = rig.rotator.moveAt(kRotatorGpredict, rotctld::MoveDirection::Right, 99.0_deg_s);
    ASSERT_TRUE(fast);
    EXPECT_TRUE(fast->startsWith(QStringLiteral("turns at ")));
    rig.run(Seconds(10.0));
    EXPECT_NEAR(rig.control.status().azimuth.commandedRate->degrees(), rig.profile.jog.fast.degrees(), 1e-6);
}

// Story: the operator had made a client read-only, and it still set the speed for the motions of another client.
// REQ-CONTROL-23a
TEST(StationRotator, OnlyWhoMayMoveSetsTheSpeed)
{
    RotatorRig rig;
    const rotctld::Client other{.id = 2, .address = "10.0.0.9:50000"};
    rig.rotator.clientConnected(kRotatorGpredict);
    rig.rotator.clientConnected(other);
    EXPECT_TRUE(rig.rotator.setSpeedLevel(kRotatorGpredict, 4));
    ASSERT_TRUE(rig.pointTo(20.0, 20.0));
    const Result<> refused = rig.rotator.setSpeedLevel(other, 1);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Refused);
    EXPECT_EQ(rig.lastLog().substr(0, 16), "V SPEED refused:");
    ASSERT_TRUE(rig.rotator.move(kRotatorGpredict, rotctld::MoveDirection::Right, 0));
    rig.run(Seconds(5.0));
    EXPECT_NEAR(rig.control.status().azimuth.commandedRate->degrees(), rig.profile.jog.fast.degrees(), 1e-6);
    ASSERT_TRUE(rig.ask(request::TakeAuthority{}));
    EXPECT_FALSE(rig.rotator.setSpeedLevel(kRotatorGpredict, 1));
}

TEST(StationRotator, TheLogTellsWhatAClientSentButNotEveryRepetition)
{
    RotatorRig rig;
    for (int i = 0; i < 100; ++i) {
        ASSERT_TRUE(rig.pointTo(20.0, 20.0));
    }
    EXPECT_EQ(rig.lastLog(), "P 20.00 20.00 accepted");
    const std::uint64_t before = rig.log.lastNumber();
    for (int i = 0; i < 1000; ++i) {
        ASSERT_TRUE(rig.pointTo(20.0 + 0.01 * i, 20.0));
    }
    EXPECT_LE(rig.log.lastNumber() - before, 3U);
}

TEST(StationRotator, ResetRearmsAfterAFaultAndIsHarmlessElse)
{
    RotatorRig rig;
    EXPECT_TRUE(rig.rotator.reset(kRotatorGpredict, 1));
    EXPECT_EQ(rig.commands(), 0U);
    ASSERT_TRUE(rig.pointTo(20.0, 20.0));
    rig.run(Seconds(0.5));
    rig.elevation.mode = moteus::Mode::Fault;
    rig.elevation.fault = 33;
    rig.run(Seconds(0.5));
    EXPECT_EQ(rig.state(), StationState::Fault);
    EXPECT_TRUE(rig.rotator.reset(kRotatorGpredict, 1));
    rig.run(Seconds(0.5));
    EXPECT_EQ(rig.state(), StationState::Standby);
}

// Story: one port scanner used up the log lines of the second. The reason why another client was dropped was never
// logged.
TEST(StationRotator, ComingAndGoingDoesNotHideWhyAClientWasDropped)
{
    RotatorRig rig;
    for (std::uint64_t i = 10; i < 60; ++i) {
        const rotctld::Client passer{.id = i, .address = "127.0.0.1:" + std::to_string(40000 + i)};
        rig.rotator.clientConnected(passer);
        rig.rotator.clientGone(passer, QStringLiteral("closed the connection"));
    }
    rig.rotator.clientRemark(kRotatorGpredict, QStringLiteral("dropped: sent 4096 bytes without a line end"));
    EXPECT_EQ(rig.lastLog(), "dropped: sent 4096 bytes without a line end");
}

TEST(StationRotator, ATargetOutsideTheLimitsIsToldInTheLog)
{
    RotatorRig rig;
    ASSERT_TRUE(rig.pointTo(10.0, -20.0));
    const auto lines = rig.log.since(0, 5);
    EXPECT_TRUE(std::ranges::any_of(lines, [](const LogEntry& line) {
        return line.text.contains(QStringLiteral("because of a limit (elevation -20")) &&
               line.severity == Severity::Warning;
    }));
}

TEST(StationRotator, ResetWithoutDrivesIsAnError)
{
    RotatorRig rig;
    rig.azimuth.silent = rig.elevation.silent = true;
    rig.run(Seconds(2.0));
    EXPECT_EQ(rig.rotator.reset(kRotatorGpredict, 1).error().code, ErrorCode::NoAnswer);
}

TEST(StationRotator, ResetSaysSoWhenItCannotRearm)
{
    RotatorRig rig;
    ASSERT_TRUE(rig.pointTo(20.0, 20.0));
    rig.run(Seconds(0.5));
    rig.elevation.silent = true;
    rig.run(Seconds(0.5));
    EXPECT_EQ(rig.rotator.reset(kRotatorGpredict, 1).error().code, ErrorCode::NoAnswer);
}

TEST(StationRotator, AContinuousAzimuthOutsideTheTravelIsADirection)
{
    RotatorRig rig(withConvention(profile::AzimuthConvention::Continuous));
    ASSERT_TRUE(rig.pointTo(-200.0, 30.0));
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 160.0, 0.001);
    ASSERT_TRUE(rig.pointTo(400.0, 30.0));
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 400.0, 0.001);
}

std::string becameOf(RotatorRig& rig, double azimuthDegrees, double elevationDegrees)
{
    const Result<QString> answer = rig.pointTo(azimuthDegrees, elevationDegrees);
    rig.run(Seconds(0.1));
    return answer ? answer->toStdString() : "refused";
}

// REQ-ROTCTLD-1412: If the mount does not go to exactly what the client wrote, a text describes the difference: another
// wrap, the other side of the zenith, or the nearest permitted place with the reason.
TEST(StationRotator, SaysWhatBecameOfATarget)
{
    RotatorRig rig;
    EXPECT_EQ(becameOf(rig, 335, 55), "");
    EXPECT_EQ(becameOf(rig, 0, 55), "");
    EXPECT_EQ(becameOf(rig, 360, 55), "");
    EXPECT_EQ(becameOf(rig, 400, 30), "az 40.0° (one turn less)");
    EXPECT_EQ(becameOf(rig, -10, 30), "az 350.0° (one turn more)");
    EXPECT_EQ(becameOf(rig, 760, 30), "az 40.0° (2 turns less)");
    EXPECT_EQ(becameOf(rig, 30, 120), "210.0° / 60.0° (the same direction)");
    EXPECT_EQ(becameOf(rig, 30, -1), "30.0° / 0.0°: elevation -1.0° below limit 0.0°");
}

TEST(StationRotator, SaysWhichTurnATargetBeyondTheTravelBecomes)
{
    RotatorRig rig(withConvention(profile::AzimuthConvention::Continuous));
    EXPECT_EQ(becameOf(rig, 400, 30), "");
    EXPECT_EQ(becameOf(rig, -60, 30), "");
    EXPECT_EQ(becameOf(rig, -200, 30), "az 160.0° (one turn more)");
    RotatorRig half(withConvention(profile::AzimuthConvention::PlusMinus180));
    EXPECT_EQ(becameOf(half, -180, 30), "");
    EXPECT_EQ(becameOf(half, 190, 30), "az -170.0° (one turn less)");
}

TEST(StationRotator, SaysWhereItGoesForATargetInAKeepOut)
{
    profile::Profile profile;
    profile.limits.keepOuts = {
        {.name = "mast", .azimuthFrom = 300_deg, .azimuthTo = 330_deg, .elevationMin = 0_deg, .elevationMax = 40_deg}};
    RotatorRig rig(profile);
    EXPECT_EQ(becameOf(rig, 328, 10), "330.0° / 10.0°: 328.0° / 10.0° lies in keep-out \"mast\"");
}

TEST(StationRotator, StopOfTheOperatorRefusesTheClient)
{
    RotatorRig rig;
    ASSERT_TRUE(rig.ask(request::Stop{}));
    EXPECT_EQ(rig.pointTo(10.0, 10.0).error().code, ErrorCode::Refused);
    EXPECT_TRUE(rig.rotator.stop(kRotatorGpredict));
    EXPECT_TRUE(rig.rotator.position(kRotatorGpredict));
}

// A stream that rises by 0.5°/s and ends, while one client still reads the position every 0.8 s.
StationState afterSilence(RotatorRig& rig, const rotctld::Client& reader)
{
    for (int i = 0; i < 10; ++i) {
        EXPECT_TRUE(rig.pointTo(10.0, 10.0 + 0.5 * i));
        rig.run(Seconds(1.0));
    }
    for (int i = 0; i < 6; ++i) {
        rig.run(Seconds(0.8));
        EXPECT_TRUE(rig.rotator.position(reader));
    }
    return rig.state();
}

// REQ-LISTENERS-12
TEST(StationRotator, ItsTargetIsWhatTheClientAskedFor)
{
    RotatorRig rig;
    EXPECT_EQ(rig.rotator.target()->elevation, 0_deg) << "where it stands";
    ASSERT_TRUE(rig.pointTo(40.0, -5.0));
    rig.settle();
    EXPECT_EQ(rig.rotator.target()->azimuth, 40_deg);
    EXPECT_EQ(rig.rotator.target()->elevation, -5_deg) << "although the axis ends at 0°";
    rig.rotator.clientGone(kRotatorGpredict, QStringLiteral("closed"));
    EXPECT_EQ(rig.rotator.target()->elevation, -5_deg);
    ASSERT_TRUE(rig.rotator.stop(kRotatorGpredict));
    EXPECT_NEAR(rig.rotator.target()->elevation.degrees(), 0.0, 1e-9) << "where it was stopped";
    rig.elevation.silent = true;
    rig.run(Seconds(3.0));
    EXPECT_FALSE(rig.rotator.target());
}

// REQ-CONTROL-12: A client that reads the position keeps its own stream alive, and no other stream.
TEST(StationRotator, AClientThatReadsOnIsContentWithThePathOfItsStream)
{
    RotatorRig rig;
    EXPECT_EQ(afterSilence(rig, kRotatorGpredict), StationState::Track);
    EXPECT_NEAR(rig.elevationDegrees(), 10.0 + 0.5 * (10.0 + 4.8), 0.1);
    rig.rotator.clientGone(kRotatorGpredict, QStringLiteral("closed"));
    rig.settle();
    EXPECT_NEAR(rig.elevationDegrees(), 14.5, 0.001);
}

// REQ-CONTROL-12
TEST(StationRotator, AnotherClientThatReadsSaysNothingAboutAStream)
{
    RotatorRig rig;
    EXPECT_NE(afterSilence(rig, {.id = 2, .address = "127.0.0.1:50001"}), StationState::Track);
    rig.settle();
    EXPECT_NEAR(rig.elevationDegrees(), 14.5, 0.001);
}

}  // namespace
}  // namespace boresight
