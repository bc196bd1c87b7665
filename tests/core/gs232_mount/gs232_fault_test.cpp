// SPDX-License-Identifier: GPL-3.0-or-later
// The faults of a GS-232 rotator: the reaction and the alarm of Boresight.
#include "tests/core/gs232_mount/gs232_bench.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace boresight::gs232 {
namespace {

struct Fault
{
    const char* name;
    std::function<void(Gs232Bench&)> happens;  // called three seconds after the start of a slew from 10° to 90°
    const char* alarm;                         // the expected alarm; "": the motion continues
    double within;                             // s, until the alarm
};

// REQ-GS232-20 (Gs232Fault.*): Each fault of a GS-232 rotator in motion ends the motion with a stop and a separate
// alarm. Nothing moves before a re-arm. A fault that disappears by itself does not end the motion.
class Gs232Fault : public testing::TestWithParam<Fault>
{
protected:
    Gs232Bench bench;
};

TEST_P(Gs232Fault, EndsTheMotionOrPasses)
{
    const Fault& fault = GetParam();
    bench.run(Seconds(2.0));
    ASSERT_TRUE(bench.goTo(90.0, 60.0));
    bench.run(Seconds(3.0));
    ASSERT_GT(bench.truth().azimuth, 14_deg);
    const int stops = bench.heardOf("S");
    fault.happens(bench);
    bench.run(Seconds(fault.within));
    if (*fault.alarm == '\0') {
        EXPECT_FALSE(bench.control().faultLatched());
        bench.run(Seconds(30.0));
        bench.expectAt({90_deg, 60_deg}, {}, 1_deg);
        EXPECT_EQ(bench.control().state(), StationState::Hold);
        return;
    }
    EXPECT_TRUE(bench.standsOnBoard(fault.alarm));
    EXPECT_TRUE(bench.control().faultLatched());
    // The line and the box work again.
    bench.box().faults() = {};
    bench.setLine(true);
    bench.run(Seconds(8.0));
    EXPECT_GT(bench.heardOf("S"), stops);
    EXPECT_TRUE(bench.stands(Seconds(5.0)));
    EXPECT_FALSE(bench.goTo(20.0, 20.0));
    ASSERT_TRUE(bench.ask(request::Rearm{}));
    bench.run(Seconds(1.0));
    EXPECT_TRUE(bench.stands(Seconds(3.0))) << "a re-arm moves nothing";
    EXPECT_FALSE(bench.standsOnBoard(fault.alarm));
    ASSERT_TRUE(bench.goTo(20.0, 20.0));
    bench.run(Seconds(30.0));
    bench.expectAt({20_deg, 20_deg}, {}, 1_deg);
}

void jumpBy(Gs232Bench& bench, Angle angle)
{
    bench.box().faults().offset = angle;
}

INSTANTIATE_TEST_SUITE_P(
    Faults, Gs232Fault,
    testing::Values(
        Fault{"CableUnplugged", [](Gs232Bench& bench) { bench.setLine(false); }, "rotator.silent", 2.0},
        Fault{"Silence", [](Gs232Bench& bench) { bench.box().faults().silent = true; }, "rotator.silent", 2.0},
        Fault{"PowerOff", [](Gs232Bench& bench) { bench.box().faults().silent = bench.box().faults().deaf = true; },
              "rotator.silent", 2.0},
        Fault{"MotorsFreeze", [](Gs232Bench& bench) { bench.box().faults().frozen = true; }, "rotator.stuck", 6.0},
        Fault{"PositionFreezes", [](Gs232Bench& bench) { bench.box().faults().stuckMeter = true; }, "rotator.stuck",
              6.0},
        Fault{"RefusesAll", [](Gs232Bench& bench) { bench.box().faults().refuses = true; }, "rotator.silent", 2.0},
        Fault{"JumpByAWholeTurn", [](Gs232Bench& bench) { jumpBy(bench, 360_deg); }, "rotator.jumped", 1.0},
        Fault{"JumpBackwards", [](Gs232Bench& bench) { jumpBy(bench, -20_deg); }, "rotator.jumped", 1.0},
        Fault{"OnlyItsEcho",
              [](Gs232Bench& bench) { bench.box().faults().echoes = bench.box().faults().silent = true; },
              "rotator.silent", 2.0},
        Fault{"Echo", [](Gs232Bench& bench) { bench.box().faults().echoes = true; }, "", 3.0},
        Fault{"HalfLines", [](Gs232Bench& bench) { bench.box().faults().halfLines = true; }, "", 3.0},
        Fault{"RestartInMidMove", [](Gs232Bench& bench) { bench.box().restart(bench.clock().now()); }, "", 3.0}),
    [](const auto& one) { return std::string(one.param.name); });

// REQ-GS232-21: Boresight checks that a stop works. If the rotator does not obey, the stop is repeated each second.
// After six seconds an alarm reports that the rotator still moves.
TEST(Gs232Stop, IsRepeatedUntilTheRotatorStands)
{
    Gs232Bench bench;
    bench.run(Seconds(2.0));
    ASSERT_TRUE(bench.goTo(400.0, 20.0));
    bench.run(Seconds(3.0));
    // Somebody holds the button of the box, so it turns whatever is sent.
    bench.box().take("W440 020\r", bench.clock().now());
    bench.box().faults().stuckRelay = true;
    ASSERT_TRUE(bench.ask(request::Stop{}));
    bench.run(Seconds(2.0));
    EXPECT_EQ(bench.heardOf("S"), 1);
    bench.run(Seconds(5.0));
    EXPECT_GE(bench.heardOf("S"), 4);
    EXPECT_TRUE(bench.standsOnBoard("rotator.runs-on"));
    bench.box().faults().stuckRelay = false;
    bench.run(Seconds(5.0));
    EXPECT_TRUE(bench.stands(Seconds(5.0)));
    EXPECT_LT(bench.truth().azimuth, 150_deg);
}

// Story: the set-points need a longer way to stop than the box. The next jog of one axis moved the other axis to its
// last set-point.
TEST(Gs232Stop, LeavesBothAxesWhereTheyStand)
{
    Gs232Bench bench;
    bench.run(Seconds(2.0));
    ASSERT_TRUE(bench.goTo(200.0, 80.0));
    bench.run(Seconds(4.0));
    ASSERT_TRUE(bench.ask(request::Stop{}));
    bench.run(Seconds(8.0));
    const AxisPosition stood = bench.truth();
    ASSERT_LT(stood.elevation, 75_deg);
    ASSERT_TRUE(bench.ask(request::ResetStop{}));
    bench.run(Seconds(1.0));
    for (int tick = 0; tick < 20; ++tick) {
        ASSERT_TRUE(bench.ask(request::Jog{.rates = {.azimuth = 2_deg_s}}));
        bench.run(Seconds(0.1));
    }
    bench.run(Seconds(8.0));
    EXPECT_GT(bench.truth().azimuth, stood.azimuth + 1_deg);
    EXPECT_NEAR(bench.truth().elevation.degrees(), stood.elevation.degrees(), 0.6) << "nobody asked for it";
}

// Story: the connection closed and opened again between two ticks. The motion continued, although another box could be
// connected by then.
TEST(Gs232Stop, ALineThatWasAwayForAMomentEndsTheMotion)
{
    Gs232Bench bench;
    bench.run(Seconds(2.0));
    ASSERT_TRUE(bench.goTo(200.0, 20.0));
    bench.run(Seconds(4.0));
    bench.mount().lineClosed();
    bench.mount().lineOpened();
    bench.run(Seconds(3.0));
    EXPECT_TRUE(bench.control().faultLatched());
    EXPECT_TRUE(bench.standsOnBoard("rotator.silent"));
    bench.run(Seconds(8.0));
    EXPECT_TRUE(bench.stands(Seconds(5.0)));
    EXPECT_LT(bench.truth().azimuth, 100_deg);
}

// Story: this computer slept for 20 s. When a reply from before the sleep waited in the port, the motion continued.
// REQ-GS232-29: A suspend of this computer for longer than the silence limit ends the motion, also when a reply waited
// meanwhile. One re-arm is enough.
TEST(Gs232Stop, ASleepOfTheComputerEndsTheMotion)
{
    for (int phase = 0; phase < 25; ++phase) {
        Gs232Bench bench;
        bench.run(Seconds(2.0));
        ASSERT_TRUE(bench.goTo(200.0, 20.0));
        bench.run(Seconds(4.0) + kOneTick * phase);
        bench.clock().sleep(Seconds(20.0));
        bench.run(Seconds(3.0));
        EXPECT_TRUE(bench.control().faultLatched()) << phase;
        EXPECT_TRUE(bench.standsOnBoard("rotator.silent")) << phase;
        EXPECT_FALSE(bench.standsOnBoard("rotator.jumped")) << phase;
        EXPECT_TRUE(bench.stands(Seconds(5.0))) << phase;
        EXPECT_LT(bench.truth().azimuth, 100_deg) << phase;
        ASSERT_TRUE(bench.ask(request::Rearm{})) << phase;
        bench.run(Seconds(0.5));
        EXPECT_TRUE(bench.goTo(200.0, 20.0)) << phase;
    }
}

// Story: after a hold the rotator was not taken over yet, so its broken line was no fault, and it moved on.
TEST(Gs232Stop, ALineThatWasAwayWhileItIsTakenOverIsAFault)
{
    for (const double seconds : {0.04, 0.5, 1.0}) {
        Gs232Bench bench(switchedProfile());
        bench.run(Seconds(2.0));
        ASSERT_TRUE(bench.goTo(200.0, 20.0));
        bench.run(Seconds(4.0));
        ASSERT_TRUE(bench.ask(request::Hold{}));
        bench.run(Seconds(seconds));
        bench.mount().lineClosed();
        bench.mount().lineOpened();
        bench.run(Seconds(3.0));
        EXPECT_TRUE(bench.control().faultLatched()) << seconds;
        EXPECT_TRUE(bench.standsOnBoard("rotator.silent")) << seconds;
        bench.run(Seconds(8.0));
        EXPECT_TRUE(bench.stands(Seconds(5.0)));
    }
}

// REQ-GS232-24: A converter that alternates between two counts does not count as a motion.
TEST(Gs232Stop, AFlickerOfOneCountIsNoMotion)
{
    ObedienceWatch watch(Angle{});
    SteadyTime now = SteadyTime{} + std::chrono::hours(1);
    watch.place(89_deg, now);
    watch.place(90_deg, now);
    watch.stopped(now);
    for (int count = 0; count < 60; ++count) {
        now += std::chrono::milliseconds(250);
        watch.place(count % 2 == 0 ? 89_deg : 90_deg, now);
        EXPECT_NE(watch.judge(now), ObedienceWatch::Verdict::RunsOn);
    }
    EXPECT_FALSE(watch.stopping());
}

// REQ-GS232-24
TEST(Gs232Stop, ASlowMotorIsNotStuckAndABlockedOneIsInSpiteOfNoise)
{
    SteadyTime now = SteadyTime{} + std::chrono::hours(1);
    ObedienceWatch slow(2_deg);
    slow.place(90_deg, now);
    slow.sent(100_deg, now);
    ObedienceWatch blocked = slow;
    bool isStuck = false;
    for (int count = 0; count < 80; ++count) {
        now += std::chrono::milliseconds(250);
        slow.place(Angle::fromDegrees(90 + count / 12), now);  // 0.33 °/s
        blocked.place(Angle::fromDegrees(90 + count % 3 - 1), now);
        blocked.sent(Angle::fromDegrees(100 + count), now);
        EXPECT_NE(slow.judge(now), ObedienceWatch::Verdict::Stuck);
        isStuck = isStuck || blocked.judge(now) == ObedienceWatch::Verdict::Stuck;
    }
    EXPECT_TRUE(isStuck);
}

// REQ-GS232-67: A lost stop of a slow motor is noticed and repeated, also right behind its start.
TEST(Gs232Stop, ALostStopOfASlowMotorIsRepeated)
{
    for (const bool obeys : {true, false}) {
        Gs232Bench bench(switchedProfile());
        bench.setPace({0.12, 0.12});
        bench.run(Seconds(2.0));
        for (int i = 0; i < 8; ++i) {
            ASSERT_TRUE(bench.ask(request::Jog{.rates = {.azimuth = 6_deg_s}}));
            bench.run(Seconds(0.1));
        }
        ASSERT_EQ(bench.box().starts(), 1);
        bench.box().faults().stuckRelay = true;
        ASSERT_TRUE(bench.ask(request::Hold{}));
        bench.run(Seconds(1.0));
        bench.box().faults().stuckRelay = !obeys;
        bench.run(Seconds(7.0));
        EXPECT_GE(bench.heardOf("S"), 2);
        EXPECT_EQ(bench.standsOnBoard("rotator.runs-on"), !obeys);
        EXPECT_TRUE(!obeys || bench.stands(Seconds(3.0)));
    }
}

// A stop that works is sent only once.
TEST(Gs232Stop, IsSentOnce)
{
    Gs232Bench bench;
    bench.run(Seconds(2.0));
    ASSERT_TRUE(bench.goTo(200.0, 20.0));
    bench.run(Seconds(5.0));
    ASSERT_TRUE(bench.ask(request::Stop{}));
    bench.run(Seconds(10.0));
    EXPECT_EQ(bench.heardOf("S"), 1);
    EXPECT_TRUE(bench.stands(Seconds(5.0)));
}

// REQ-GS232-22: A box that does not answer receives one query each second, and the alarm says what to check.
TEST(Gs232Start, ASilentBoxIsAskedOnAndNothingElse)
{
    Gs232Bench bench;
    bench.box().faults().silent = true;
    bench.run(Seconds(10.0));
    EXPECT_TRUE(bench.standsOnBoard("rotator.no-answer"));
    EXPECT_EQ(bench.heardOf("C2"), static_cast<int>(bench.box().heard().size()));
    EXPECT_LE(bench.heardOf("C2"), 11);
    EXPECT_FALSE(bench.goTo(60.0, 45.0));
    bench.box().faults().silent = false;
    bench.run(Seconds(2.0));
    EXPECT_FALSE(bench.standsOnBoard("rotator.no-answer"));
    EXPECT_TRUE(bench.goTo(60.0, 45.0));
}

// REQ-GS232-23: A travel that the box cannot count is refused. The refusal names the keys to change.
TEST(Gs232Start, ATravelThatItCannotCountIsRefused)
{
    profile::Profile profile = gs232Profile();
    profile.azimuth.geometry.travel = {.min = -90_deg, .max = 450_deg};
    const profile::InForce inForce(profile);
    fakes::ManualClock clock;
    EventLog log(clock);
    AlarmBoard alarms(log, clock);
    const Gs232Mount mount(inForce, alarms, kAxes);
    ASSERT_FALSE(mount.interlock());
    EXPECT_TRUE(mount.interlock().error().text.contains(QStringLiteral("azimuth.travel_min_deg")));
    EXPECT_TRUE(Gs232Bench().mount().interlock());
}

// REQ-GS232-27 (Gs232Rest.*): A fault of a rotator that stands still moves nothing.
TEST(Gs232Rest, AJumpIsReportedAndNothingMoves)
{
    Gs232Bench bench;
    bench.run(Seconds(2.0));
    ASSERT_TRUE(bench.goTo(60.0, 40.0));
    bench.run(Seconds(20.0));
    jumpBy(bench, 360_deg);
    bench.run(Seconds(1.0));
    EXPECT_TRUE(bench.standsOnBoard("rotator.jumped"));
    EXPECT_TRUE(bench.control().faultLatched());
    EXPECT_TRUE(bench.stands(Seconds(10.0)));
}

TEST(Gs232Rest, AMotionThatNobodyOrderedIsStopped)
{
    Gs232Bench bench;
    bench.run(Seconds(5.0));
    ASSERT_TRUE(bench.ask(request::Stop{}));
    bench.run(Seconds(5.0));
    bench.box().take("W200 020\r", bench.clock().now());
    bench.run(Seconds(8.0));
    EXPECT_GE(bench.heardOf("S"), 1);
    EXPECT_LT(bench.truth().azimuth, 30_deg);
    EXPECT_TRUE(bench.stands(Seconds(10.0)));
}

TEST(Gs232Rest, AnAzimuthRotatorWithAProfileOfTwoAxesIsTold)
{
    Gs232Bench bench(Gs232Box::Habits{.elevation = false});
    bench.run(Seconds(5.0));
    EXPECT_TRUE(bench.standsOnBoard("rotator.no-answer"));
    const auto alarms = bench.control().status().alarms;
    EXPECT_TRUE(std::ranges::any_of(
        alarms, [](const Alarm& one) { return one.remedy.contains(QStringLiteral("elevation.driver")); }));
    EXPECT_FALSE(bench.goTo(60.0, 45.0));
    EXPECT_FALSE(bench.ordered());
}

// REQ-GS232-25: The box counts its angles itself. A sign or an offset in the profile is refused, with the keys and what
// to do. The values of a new profile are accepted.
TEST(Gs232Counts, ASignOrAnOffsetIsRefused)
{
    const auto refusal = [](int sign, Angle offset) {
        profile::Profile profile = gs232Profile();
        profile.elevation.geometry.sign = sign;
        profile.elevation.geometry.offset = offset;
        Gs232Bench bench(profile);
        bench.run(Seconds(2.0));
        const Result<>& interlock = bench.mount().interlock();
        EXPECT_EQ(bench.goTo(60.0, 45.0).has_value(), interlock.has_value());
        return interlock ? QString() : interlock.error().text;
    };
    for (const QString& text : {refusal(-1, 0_deg), refusal(1, 5_deg), refusal(-1, 88_deg)}) {
        EXPECT_TRUE(text.contains(QStringLiteral("elevation.sign"))) << text.toStdString();
        EXPECT_TRUE(text.contains(QStringLiteral("elevation.offset_deg"))) << text.toStdString();
    }
    EXPECT_EQ(refusal(1, 0_deg), QString());
    const pointing::AxisGeometry usual = profile::Profile().elevation.geometry;
    EXPECT_EQ(refusal(usual.sign, usual.offset), QString());
}

// REQ-GS232-26: An end of the travel between two whole degrees of the box is rounded inwards.
TEST(Gs232Counts, EndInsideTheTravel)
{
    profile::Profile profile = gs232Profile();
    profile.azimuth.geometry.travel = {.min = Angle::fromDegrees(5.5), .max = Angle::fromDegrees(60.5)};
    profile.park.azimuth = 10_deg;
    Gs232Bench bench(profile);
    bench.run(Seconds(2.0));
    ASSERT_TRUE(bench.goTo(6.0, 60.0));
    bench.run(Seconds(20.0));
    bench.expectAt({6_deg, 60_deg}, {}, 0.6_deg);
    for (const AngularRate rate : {AngularRate::fromDegrees(6.0), AngularRate::fromDegrees(-6.0)}) {
        ASSERT_TRUE(bench.ask(request::Move{{.azimuth = rate}}));
        bench.run(Seconds(20.0));
    }
    for (const std::string& one : bench.box().heard()) {
        EXPECT_FALSE(one.starts_with("W005") || one.starts_with("W061")) << one;
    }
}

// REQ-GS232-28: A keep-out that is added on the way of a slow rotator stops it. Boresight checks this stop like any
// other: a rotator that still moves is a fault.
TEST(Gs232Retake, ItsStopIsWatched)
{
    profile::Profile profile = gs232Profile();
    Gs232Bench bench(profile);
    bench.run(Seconds(2.0));
    bench.setPace({1.0 / 6.0, 1.0});
    ASSERT_TRUE(bench.goTo(90.0, 60.0));
    bench.run(Seconds(12.0));
    ASSERT_LT(bench.truth().azimuth, 30_deg);
    bench.box().faults().stuckRelay = true;
    profile.limits.keepOuts = {{.name = "wall",
                                .azimuthFrom = bench.truth().azimuth + 8_deg,
                                .azimuthTo = 80_deg,
                                .elevationMin = 0_deg,
                                .elevationMax = 90_deg}};
    bench.edit(profile);
    bench.run(Seconds(8.0));
    EXPECT_TRUE(bench.standsOnBoard("rotator.runs-on"));
    EXPECT_TRUE(bench.control().faultLatched());
}

}  // namespace
}  // namespace boresight::gs232
