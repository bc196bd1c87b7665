// SPDX-License-Identifier: GPL-3.0-or-later
// The faults of a rotctld and of the rotator behind it: the reaction and the alarm of Boresight.
#include "tests/core/rotctld_mount/rotctld_bench.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace boresight::rotctl {
namespace {

struct Fault
{
    const char* name;
    std::function<void(RotctldBench&)> happens;  // called three seconds after the start of a slew from 10° to 90°
    const char* alarm;                           // the expected alarm; "": the motion continues
    double within;                               // s, until the alarm
};

// REQ-ROTCTLDMOUNT-20 (RotctldFault.*): Each fault of a rotctld during a motion ends the motion with a stop and a
// separate alarm. Nothing moves before a re-arm. A fault that disappears by itself does not end the motion.
class RotctldFault : public testing::TestWithParam<Fault>
{
protected:
    RotctldBench bench;
};

TEST_P(RotctldFault, EndsTheMotionOrPasses)
{
    const Fault& fault = GetParam();
    bench.run(Seconds(2.0));
    ASSERT_TRUE(bench.goTo(90.0, 60.0));
    bench.run(Seconds(3.0));
    ASSERT_GT(bench.truth().azimuth, 14_deg);
    const int stops = bench.heardOf("+\\stop");
    fault.happens(bench);
    bench.run(Seconds(fault.within));
    if (*fault.alarm == '\0') {
        EXPECT_FALSE(bench.control().faultLatched());
        bench.run(Seconds(30.0));
        bench.expectAt({90_deg, 60_deg}, {}, 0.2_deg);
        EXPECT_EQ(bench.control().state(), StationState::Hold);
        return;
    }
    EXPECT_TRUE(bench.alarm(fault.alarm));
    EXPECT_TRUE(bench.control().faultLatched());
    // The network, the server and the rotator work again.
    bench.box().faults() = {};
    bench.setLine(true);
    bench.run(Seconds(8.0));
    EXPECT_GT(bench.heardOf("+\\stop"), stops);
    EXPECT_TRUE(bench.stands(Seconds(5.0)));
    EXPECT_FALSE(bench.goTo(20.0, 20.0));
    ASSERT_TRUE(bench.ask(request::Rearm{}));
    bench.run(Seconds(1.0));
    EXPECT_TRUE(bench.stands(Seconds(3.0))) << "a re-arm moves nothing";
    EXPECT_FALSE(bench.alarm(fault.alarm));
    ASSERT_TRUE(bench.goTo(20.0, 20.0));
    bench.run(Seconds(30.0));
    bench.expectAt({20_deg, 20_deg}, {}, 0.2_deg);
}

RotctldBox::Faults& faultsOf(RotctldBench& bench)
{
    return bench.box().faults();
}

INSTANTIATE_TEST_SUITE_P(
    Faults, RotctldFault,
    testing::Values(
        Fault{"NetworkGone", [](RotctldBench& bench) { bench.setLine(false); }, "rotator.silent", 2.0},
        Fault{"ServerHangs", [](RotctldBench& bench) { faultsOf(bench).silent = faultsOf(bench).deaf = true; },
              "rotator.silent", 2.0},
        Fault{"ServerAnswersNothing", [](RotctldBench& bench) { faultsOf(bench).silent = true; }, "rotator.silent",
              2.0},
        Fault{"RotatorAnswersNothing",
              [](RotctldBench& bench) { faultsOf(bench).position = faultsOf(bench).order = ErrorCode::NoAnswer; },
              "rotator.refused", 2.0},
        Fault{"PositionFails", [](RotctldBench& bench) { faultsOf(bench).position = ErrorCode::NoAnswer; },
              "rotator.silent", 2.0},
        Fault{"TargetsRefused", [](RotctldBench& bench) { faultsOf(bench).order = ErrorCode::Refused; },
              "rotator.refused", 3.0},
        Fault{"MotorsFreeze", [](RotctldBench& bench) { faultsOf(bench).frozen = true; }, "rotator.stuck", 6.0},
        Fault{"PositionFreezes", [](RotctldBench& bench) { faultsOf(bench).stuckPlace = true; }, "rotator.stuck", 6.0},
        Fault{"JumpByAWholeTurn", [](RotctldBench& bench) { faultsOf(bench).offset = 360_deg; }, "rotator.jumped", 1.0},
        Fault{"JumpBackByAWholeTurn", [](RotctldBench& bench) { faultsOf(bench).offset = -360_deg; }, "rotator.jumped",
              1.0},
        Fault{"JumpBackwards", [](RotctldBench& bench) { faultsOf(bench).offset = -20_deg; }, "rotator.jumped", 1.0},
        Fault{"ConnectionDropsAndComesBack",
              [](RotctldBench& bench) {
                  bench.mount().lineClosed();
                  bench.mount().lineOpened();
              },
              "rotator.silent", 1.0},
        Fault{"ServerRestarts",
              [](RotctldBench& bench) {
                  bench.box().restart(bench.clock().now());
                  bench.mount().lineClosed();
                  bench.mount().lineOpened();
              },
              "rotator.silent", 1.0},
        Fault{"HalfAnswers", [](RotctldBench& bench) { faultsOf(bench).halfAnswers = true; }, "rotator.silent", 3.0},
        Fault{"AnotherClientSendsItElsewhere",
              [](RotctldBench& bench) { bench.box().send({.azimuth = 5_deg, .elevation = 5_deg}); }, "", 3.0}),
    [](const auto& one) { return std::string(one.param.name); });

// REQ-ROTCTLDMOUNT-21: Boresight checks that a stop works. If the rotator does not obey, the stop is repeated each
// second. After six seconds an alarm reports that the rotator still moves.
TEST(RotctldStop, IsRepeatedUntilTheRotatorStands)
{
    RotctldBench bench;
    bench.run(Seconds(2.0));
    ASSERT_TRUE(bench.goTo(400.0, 20.0));
    bench.run(Seconds(3.0));
    bench.box().send({.azimuth = 440_deg, .elevation = 20_deg});
    bench.box().faults().runsOn = true;
    ASSERT_TRUE(bench.ask(request::Stop{}));
    bench.run(Seconds(2.0));
    EXPECT_EQ(bench.heardOf("+\\stop"), 1);
    bench.run(Seconds(5.0));
    EXPECT_GE(bench.heardOf("+\\stop"), 4);
    EXPECT_TRUE(bench.alarm("rotator.runs-on"));
    bench.box().faults().runsOn = false;
    bench.run(Seconds(5.0));
    EXPECT_TRUE(bench.stands(Seconds(5.0)));
}

// REQ-ROTCTLDMOUNT-22: A stop also works if the rotator has no stop command, and if the command is refused at first.
TEST(RotctldStop, WorksWhereItIsRefused)
{
    for (const ErrorCode error : {ErrorCode::NotAvailable, ErrorCode::Io}) {
        RotctldBench bench;
        bench.run(Seconds(2.0));
        ASSERT_TRUE(bench.goTo(200.0, 20.0));
        bench.run(Seconds(4.0));
        bench.box().faults().stop = error;
        ASSERT_TRUE(bench.ask(request::Stop{}));
        bench.run(Seconds(1.0));
        if (error == ErrorCode::Io) {
            EXPECT_GE(bench.heardOf("+\\stop"), 2);
            bench.box().faults().stop.reset();
            bench.run(Seconds(1.0));
        }
        bench.run(Seconds(2.0));
        EXPECT_TRUE(bench.stands(Seconds(10.0)));
        EXPECT_LT(bench.truth().azimuth, 60_deg);
    }
}

// REQ-ROTCTLDMOUNT-27: However long rotctld needs for each command, at most one query and the stop wait in its queue.
// So the stop is executed as soon as possible.
TEST(RotctldStop, IsNotBehindAQueue)
{
    for (const int ms : {300, 900, 1300, 1600, 2500}) {
        const std::chrono::milliseconds works(ms);
        RotctldBench bench;
        bench.run(Seconds(3.0));
        ASSERT_TRUE(bench.goTo(400.0, 20.0));
        bench.run(Seconds(1.0));
        bench.box().faults().works = works;
        std::size_t most = 0;
        for (int i = 0; i < 500; ++i) {
            bench.tick();
            most = std::max(most, bench.box().waiting());
        }
        ASSERT_TRUE(bench.ask(request::Stop{}));
        bench.run(Seconds(2 * works) + Seconds(1.0));
        EXPECT_LE(most, 2U) << works.count();
        EXPECT_TRUE(bench.stands(Seconds(5.0))) << works.count();
    }
}

// REQ-ROTCTLDMOUNT-28: A rotator without a stop command is sent to its believed position, always inside the limits of
// rotctld. A single wrong answer does not change this position, and neither does a value below the horizon that is only
// noise of the sensor.
TEST(RotctldStop, SendsARotatorWithoutOneNowhereElse)
{
    RotctldBench bench;
    bench.box().faults().stop = ErrorCode::NotAvailable;
    bench.run(Seconds(2.0));
    ASSERT_TRUE(bench.goTo(200.0, 20.0));
    bench.run(Seconds(4.0));
    bench.box().faults().offset = 360_deg;
    bench.run(Seconds(0.3));
    ASSERT_TRUE(bench.ask(request::Stop{}));
    bench.run(Seconds(0.1));
    bench.box().faults().offset = {};
    bench.run(Seconds(3.0));
    EXPECT_TRUE(bench.stands(Seconds(10.0)));
    EXPECT_LT(bench.truth().azimuth, 60_deg);

    RotctldBench low;
    low.box().faults().stop = ErrorCode::NotAvailable;
    low.run(Seconds(2.0));
    ASSERT_TRUE(low.goTo(20.0, 0.0));
    low.run(Seconds(10.0));
    ASSERT_TRUE(low.goTo(300.0, 0.0));
    low.run(Seconds(2.0));
    low.box().faults().sag = 0.3_deg;
    low.run(Seconds(1.0));
    ASSERT_TRUE(low.ask(request::Stop{}));
    low.run(Seconds(3.0));
    EXPECT_TRUE(low.stands(Seconds(10.0)));
    EXPECT_LT(low.truth().azimuth, 60_deg);
}

// REQ-ROTCTLDMOUNT-23: A server that does not answer still receives queries, and the alarm says what to check. The same
// holds for a server whose rotator does not answer: the alarm has the error of Hamlib in words.
TEST(RotctldStart, WhatDoesNotAnswerIsAskedOnAndNothingElse)
{
    RotctldBench silent;
    silent.box().faults().silent = true;
    silent.run(Seconds(10.0));
    ASSERT_TRUE(silent.alarm("rotator.no-answer"));
    EXPECT_TRUE(silent.alarm("rotator.no-answer")->remedy.contains(QStringLiteral("rotctld still runs")));
    EXPECT_FALSE(silent.goTo(60.0, 45.0));
    EXPECT_FALSE(silent.ordered());
    silent.box().faults().silent = false;
    silent.run(Seconds(14.0));
    EXPECT_FALSE(silent.alarm("rotator.no-answer"));
    EXPECT_TRUE(silent.goTo(60.0, 45.0));

    RotctldBench dead;
    dead.box().faults().position = ErrorCode::NoAnswer;
    dead.run(Seconds(5.0));
    ASSERT_TRUE(dead.alarm("rotator.no-answer"));
    EXPECT_TRUE(dead.alarm("rotator.no-answer")->remedy.contains(QStringLiteral("(RPRT -6)")));
    EXPECT_FALSE(dead.goTo(60.0, 45.0));
    EXPECT_FALSE(dead.ordered());
}

// REQ-ROTCTLDMOUNT-24: A travel outside the limits of rotctld is refused, with the keys to change. So are an axis that
// the rotator does not have, and a sign or an offset in the profile.
TEST(RotctldStart, AProfileThatDoesNotFitIsRefused)
{
    const auto refusal = [](const profile::Profile& profile) {
        RotctldBench bench(profile);
        bench.run(Seconds(2.0));
        const Result<>& interlock = bench.mount().interlock();
        EXPECT_EQ(bench.goTo(60.0, 45.0).has_value(), interlock.has_value());
        EXPECT_EQ(bench.heardOf("+\\set_pos") > 0, false);
        return interlock ? QString() : interlock.error().text;
    };
    profile::Profile wide = rotctldProfile();
    EXPECT_EQ(refusal(wide), QString());
    wide.azimuth.geometry.travel = {.min = -190_deg, .max = 450_deg};
    EXPECT_TRUE(refusal(wide).contains(QStringLiteral("azimuth.travel_min_deg"))) << refusal(wide).toStdString();
    profile::Profile high = rotctldProfile();
    high.elevation.geometry.travel = {.min = 0_deg, .max = 180_deg};
    EXPECT_TRUE(refusal(high).contains(QStringLiteral("elevation.travel_max_deg")));
    profile::Profile turned = rotctldProfile();
    turned.azimuth.geometry.offset = 5_deg;
    EXPECT_TRUE(refusal(turned).contains(QStringLiteral("azimuth.offset_deg")));
}

TEST(RotctldStart, AnAxisThatTheRotatorDoesNotHaveIsTold)
{
    const profile::InForce profile(rotctldProfile());
    fakes::ManualClock clock;
    EventLog log(clock);
    AlarmBoard alarms(log, clock);
    RotctldMount mount(profile, alarms, kAxes);
    mount.lineOpened();
    mount.observe(clock.now());
    EXPECT_EQ(mount.send(), "+\\dump_state\n");
    mount.take(
        "dump_state:\nrotctld Protocol Ver: 1\nRotor Model: 601\nMinimum Azimuth: -180.0\nMaximum Azimuth: 450.0\n"
        "Minimum Elevation: 0.0\nMaximum Elevation: 90.0\nrot_type=Az\ndone\nRPRT 0\n",
        clock.now());
    mount.observe(clock.now());
    ASSERT_FALSE(mount.interlock());
    EXPECT_TRUE(mount.interlock().error().text.contains(QStringLiteral("elevation.driver")));
}

// REQ-ROTCTLDMOUNT-25: While STOP is latched, a motion that nobody commanded is stopped. A jump of the position at
// standstill moves nothing.
TEST(RotctldRest, AMotionThatNobodyOrderedIsStopped)
{
    RotctldBench bench;
    bench.run(Seconds(5.0));
    ASSERT_TRUE(bench.ask(request::Stop{}));
    bench.run(Seconds(5.0));
    bench.box().send({.azimuth = 200_deg, .elevation = 20_deg});
    bench.run(Seconds(8.0));
    EXPECT_GE(bench.heardOf("+\\stop"), 1);
    EXPECT_LT(bench.truth().azimuth, 30_deg);
    EXPECT_TRUE(bench.stands(Seconds(10.0)));
}

// REQ-ROTCTLDMOUNT-25
TEST(RotctldRest, AJumpIsReportedAndNothingMoves)
{
    RotctldBench bench;
    bench.run(Seconds(2.0));
    ASSERT_TRUE(bench.goTo(60.0, 40.0));
    bench.run(Seconds(20.0));
    bench.box().faults().offset = 360_deg;
    bench.run(Seconds(1.0));
    EXPECT_TRUE(bench.alarm("rotator.jumped"));
    EXPECT_TRUE(bench.control().faultLatched());
    EXPECT_TRUE(bench.stands(Seconds(10.0)));
}

// REQ-ROTCTLDMOUNT-26: The axis that this mount does not use is always sent to its present position.
TEST(RotctldAxes, TheOtherAxisStands)
{
    RotctldBench bench(axesIf(true, false));
    bench.run(Seconds(2.0));
    ASSERT_TRUE(bench.goTo(60.0, 0.0));
    bench.run(Seconds(20.0));
    EXPECT_NEAR(bench.truth().azimuth.degrees(), 60.0, 0.2);
    EXPECT_NEAR(bench.truth().elevation.degrees(), 20.6, 0.01);
}

}  // namespace
}  // namespace boresight::rotctl
