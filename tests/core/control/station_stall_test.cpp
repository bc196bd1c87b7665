// SPDX-License-Identifier: GPL-3.0-or-later
// This computer stalls, and the watchdogs of the drives stop the mount.
#include "tests/core/control/station_rig.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace boresight {
namespace {

using moteus::Mode;

// The effect of a stall on the drives: they receive no command for `time` and stop by themselves.
void stall(StationRig& rig, Seconds time)
{
    rig.clock.advance(time);
    rig.azimuth.mode = rig.elevation.mode = Mode::PositionTimeout;
}

bool logHas(const StationRig& rig, const QString& text)
{
    return std::ranges::any_of(rig.log.since(0, 1000), [&](const LogEntry& line) { return line.text.contains(text); });
}

// Story: one stall of 0.1 s on a busy computer ended a pass, and every later target of the client was refused.
// REQ-CONTROL-06a (StationStall.*): A stall of at most 2 s, from tick to tick or from frame to frame, can let the
// watchdogs of the drives stop the mount. The motion is then resumed within 1 s, unless the profile says "wait". Any
// doubt waits for a re-arm: a drive in fault or power-cycled, a wrap that is not proven, an axis that moved by 2°, a
// latched STOP, a drive that does not come back. Requests made meanwhile count. This also holds for several stalls in a
// row, and for a stall while drives are taken over. After a suspend of the computer, however short, the mount waits for
// a re-arm.
TEST(StationStall, TheMotionGoesOnByItself)
{
    for (const double seconds : {0.08, 0.15, 1.0, 1.97}) {
        StationRig rig;
        ASSERT_TRUE(rig.setsOff(100.0, 60.0, Seconds(2.0)));
        const double before = rig.azimuthDegrees();
        stall(rig, Seconds(seconds));
        rig.run(Seconds(0.5));
        EXPECT_EQ(rig.state(), StationState::Slew) << seconds;
        EXPECT_TRUE(rig.control.status().alarms.empty()) << seconds;
        EXPECT_TRUE(logHas(rig, QStringLiteral("resumes the motion"))) << seconds;
        EXPECT_GT(rig.azimuthDegrees(), before) << seconds;
        rig.settle();
        EXPECT_NEAR(rig.azimuthDegrees(), 100.0, 0.001) << seconds;
        EXPECT_NEAR(rig.elevationDegrees(), 60.0, 0.001) << seconds;
    }
}

// Story: after a suspend of 20 s the window blamed the bus, and only the log had the reason.
// REQ-ALARMS-304: If drives timed out because this computer stalled, the alarm says so and names the length of the
// stall. An alarm about a time-out without a stall does not mention one.
TEST(StationStall, TheAlarmAfterALongOneNamesIt)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(100.0, 60.0, Seconds(2.0)));
    stall(rig, Seconds(20.0));
    rig.run(Seconds(0.5));
    ASSERT_EQ(rig.state(), StationState::Fault);
    EXPECT_EQ(rig.control.status().alarms.front().what,
              QStringLiteral("The azimuth drive timed out because this computer stalled for 20 s."));
    StationRig other;
    ASSERT_TRUE(other.setsOff(100.0, 60.0, Seconds(2.0)));
    other.azimuth.mode = other.elevation.mode = Mode::PositionTimeout;
    other.run(Seconds(0.5));
    EXPECT_EQ(other.control.status().alarms.front().what,
              QStringLiteral("The azimuth drive timed out because it received no command in time."));
}

// Story: with STOP latched, a stall of 0.23 s was in the log, and the alarm below it blamed the bus.
// REQ-ALARMS-304
TEST(StationStall, TheAlarmAfterAShortOneNamesItToo)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(100.0, 60.0, Seconds(2.0)));
    ASSERT_TRUE(rig.ask(request::Stop{}));
    rig.run(Seconds(2.0));
    stall(rig, Seconds(0.21));  // the tick follows 0.02 s later
    rig.run(Seconds(0.5));
    ASSERT_TRUE(rig.control.faultLatched());
    EXPECT_TRUE(logHas(rig, QStringLiteral("timed out because this computer stalled for 0.23 s")));
    EXPECT_FALSE(logHas(rig, QStringLiteral("received no command in time")));
}

// Story: under load a tick began 65 ms after the one before, and its frames left 45 ms later. The drives timed out, no
// stall was detected, and a pass of two hours lost its last quarter.
TEST(StationStall, TwoDelaysThatAddUpAreOne)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(100.0, 60.0, Seconds(2.0)));
    stall(rig, Seconds(0.045));
    rig.heldUp = Seconds(0.045);
    rig.tick();
    rig.heldUp = Seconds(0.0);
    rig.run(Seconds(0.5));
    EXPECT_EQ(rig.state(), StationState::Slew);
    EXPECT_TRUE(rig.control.status().alarms.empty());
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 100.0, 0.001);
}

// With the longest watchdog time the two delays are long enough for the axes to stand somewhere else.
TEST(StationStall, TwoDelaysThatAddUpExcuseTheDrivesToo)
{
    profile::Profile patient;
    patient.control.watchdog = Seconds(0.2);
    StationRig rig(patient);
    ASSERT_TRUE(rig.setsOff(100.0, 60.0, Seconds(2.0)));
    stall(rig, Seconds(0.125));
    rig.heldUp = Seconds(0.145);
    rig.tick();
    rig.heldUp = Seconds(0.0);
    EXPECT_TRUE(logHas(rig, QStringLiteral("this computer stalled for 0.29 s")));
    rig.run(Seconds(0.5));
    EXPECT_EQ(rig.state(), StationState::Slew);
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 100.0, 0.001);
}

TEST(StationStall, TheClientIsServedMeanwhile)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(100.0, 60.0, Seconds(2.0)));
    stall(rig, Seconds(0.3));
    for (int tick = 0; tick < 30; ++tick) {
        rig.tick();
        EXPECT_TRUE(rig.point(100.0, 60.0)) << tick;
    }
}

TEST(StationStall, OneDriveOfTwoThatStoppedIsTakenOverToo)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(100.0, 60.0, Seconds(2.0)));
    rig.clock.advance(Seconds(0.09));
    rig.elevation.mode = Mode::PositionTimeout;
    rig.run(Seconds(0.5));
    EXPECT_EQ(rig.state(), StationState::Slew);
    rig.settle();
    EXPECT_NEAR(rig.elevationDegrees(), 60.0, 0.001);
}

TEST(StationStall, TheDrivesAreTakenOverByTheRules)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(100.0, 60.0, Seconds(2.0)));
    rig.azimuth.seen.clear();
    stall(rig, Seconds(0.2));
    rig.run(Seconds(0.5));
    const auto& seen = rig.azimuth.seen;
    const auto stop = std::ranges::find(seen, Mode::Stopped, &fakes::IdealDrive::Seen::mode);
    ASSERT_NE(stop, seen.end());
    const auto hold = std::find_if(stop, seen.end(), [](const auto& one) { return one.mode == Mode::Position; });
    ASSERT_NE(hold, seen.end());
    EXPECT_TRUE(std::isnan(hold->fields.at(moteus::Register::CommandPosition))) << "the place where it stands";
}

TEST(StationStall, WhatIsAskedMeanwhileCounts)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(100.0, 60.0, Seconds(2.0)));
    stall(rig, Seconds(0.3));
    rig.tick();
    rig.tick();
    ASSERT_TRUE(rig.ask(request::Stop{}));
    const double stopped = rig.azimuth.position;
    rig.run(Seconds(3.0));
    EXPECT_EQ(rig.state(), StationState::Stopped);
    EXPECT_NEAR(rig.azimuth.position, stopped, 1e-5);
}

struct Doubt
{
    const char* name;
    void (*make)(StationRig&);
};

class StallDoubt : public testing::TestWithParam<Doubt>
{};

// Anything in doubt waits for a re-arm, and nothing moves.
// REQ-CONTROL-06a (StallDoubt.*)
TEST_P(StallDoubt, WaitsForARearm)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(100.0, 60.0, Seconds(2.0)));
    GetParam().make(rig);
    rig.run(Seconds(2.5));
    EXPECT_TRUE(rig.control.faultLatched());
    const double stood = rig.azimuthDegrees();
    EXPECT_FALSE(rig.point(120.0, 60.0));
    rig.run(Seconds(3.0));
    EXPECT_NEAR(rig.azimuthDegrees(), stood, 0.001);
}

INSTANTIATE_TEST_SUITE_P(Station, StallDoubt,
                         testing::Values(Doubt{"TheProfileWaits",
                                               [](StationRig& rig) {
                                                   rig.profile.control.afterStall = profile::AfterStall::Wait;
                                                   rig.setProfile(rig.profile);
                                                   stall(rig, Seconds(0.3));
                                               }},
                                         Doubt{"TooLong", [](StationRig& rig) { stall(rig, Seconds(2.1)); }},
                                         Doubt{"NoStallAtAll",
                                               [](StationRig& rig) {
                                                   rig.azimuth.mode = rig.elevation.mode = Mode::PositionTimeout;
                                               }},
                                         Doubt{"ALongTimeAfterTheStall",
                                               [](StationRig& rig) {
                                                   rig.clock.advance(Seconds(0.3));
                                                   rig.run(Seconds(1.2));
                                                   rig.azimuth.mode = Mode::PositionTimeout;
                                               }},
                                         Doubt{"Displaced",
                                               [](StationRig& rig) {
                                                   stall(rig, Seconds(0.3));
                                                   rig.azimuth.position += 2.1 / 360.0;
                                               }},
                                         Doubt{"OneInFault",
                                               [](StationRig& rig) {
                                                   stall(rig, Seconds(0.3));
                                                   rig.elevation.mode = Mode::Fault;
                                                   rig.elevation.fault = 33;
                                               }},
                                         Doubt{"OnePowerCycled",
                                               [](StationRig& rig) {
                                                   stall(rig, Seconds(0.3));
                                                   rig.elevation.mode = Mode::Stopped;
                                               }},
                                         Doubt{"OneDoesNotComeBack",
                                               [](StationRig& rig) {
                                                   stall(rig, Seconds(0.3));
                                                   rig.azimuth.deaf = true;
                                               }}),
                         [](const auto& test) { return test.param.name; });

TEST(StationStall, BehindStopNothingIsResumed)
{
    StationRig rig;
    ASSERT_TRUE(rig.setsOff(100.0, 60.0, Seconds(2.0)));
    ASSERT_TRUE(rig.ask(request::Stop{}));
    rig.run(Seconds(2.0));
    stall(rig, Seconds(0.3));
    const double stood = rig.azimuthDegrees();
    rig.run(Seconds(2.0));
    EXPECT_TRUE(rig.control.faultLatched());
    EXPECT_EQ(rig.azimuthDegrees(), stood);
}

// A jog button that is pressed while this computer stalls sends no keep-alive either.
TEST(StationStall, AJogEnds)
{
    StationRig rig;
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.ask(request::Jog{{.azimuth = AngularRate::fromDegrees(2.0), .elevation = {}}}));
    rig.run(Seconds(0.2));
    stall(rig, Seconds(0.5));
    rig.run(Seconds(2.0));
    EXPECT_EQ(rig.state(), StationState::Hold);
}

}  // namespace
}  // namespace boresight
