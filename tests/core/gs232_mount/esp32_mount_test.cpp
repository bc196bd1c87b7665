// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/gs232_mount/esp32_bench.h"
#include "tests/core/gs232_mount/gs232_bench.h"

#include <gtest/gtest.h>

namespace boresight::gs232 {
namespace {

using std::chrono::milliseconds;

// The fake is the rotator of these tests, so its own habits are tested first.
TEST(Esp32Box, SwitchedOffRelaysSwitchOnAgain)
{
    Esp32Box box({.azimuth = 100_deg, .elevation = 20_deg});
    SteadyTime now = SteadyTime{} + std::chrono::hours(1);
    const auto after = [&](milliseconds time, const char* bytes) {
        now += time;
        box.take(bytes, now);
        return box.truth();
    };
    (void)after(milliseconds(0), "AZ 150\r");
    EXPECT_GT(after(milliseconds(2000), "SA\r").azimuth, 102_deg);
    const AxisPosition stopped = box.truth();
    EXPECT_GT(after(milliseconds(1000), "AZ 0\r").azimuth, stopped.azimuth) << "a stop keeps the target";
}

TEST(Esp32Box, AnswersAsItsSourceDoes)
{
    Esp32Box box({.azimuth = 370_deg, .elevation = 45_deg});
    SteadyTime now = SteadyTime{} + std::chrono::hours(1);
    const auto answer = [&](const char* bytes) {
        box.take(bytes, now);
        now += milliseconds(20);
        return box.answers(now);
    };
    EXPECT_EQ(answer("C2\r"), "RPRT -1\r");
    EXPECT_EQ(answer("ve\r"), "VEAdamESP32v1.0\r");
    EXPECT_EQ(answer("P\r"), "10.0 9.0\r") << "four of five readings are zeros";
    EXPECT_EQ(answer("EL\r"), "EL 18.0\r");
    EXPECT_EQ(answer("AZ-10\r"), "AZ 10.0\r") << "a question";
    EXPECT_EQ(answer("az 10\r"), "RPRT -1\r");
    EXPECT_EQ(answer(" AZ 12 \r\n\r"), "RPRT 0\r");
    EXPECT_EQ(answer("  \r"), "RPRT -1\r");
    EXPECT_EQ(answer("DEBUG\r"), "DEBUG ON\r");
    EXPECT_EQ(answer("DEBUG\r"), "DEBUG OFF\r");
    EXPECT_EQ(answer("Q\r"), "");
}

// REQ-GS232-87: A box that answers the question of a GS-232 like the ESP32 relay controller is asked for its version
// and then commanded by its own words. Nothing but questions is sent before.
TEST(Esp32Mount, IsRecognisedByAsking)
{
    Esp32Bench bench;
    EXPECT_EQ(bench.mount().kind(), QStringLiteral("GS-232"));
    bench.run(Seconds(1.0));
    EXPECT_EQ(bench.mount().kind(), QStringLiteral("ESP32"));
    EXPECT_EQ(bench.box().heard()[0], "C2");
    EXPECT_EQ(bench.box().heard()[1], "VE");
    EXPECT_FALSE(bench.ordered());
    ASSERT_TRUE(bench.mount().interlock());
}

// REQ-GS232-86
TEST(Esp32Mount, ReportsTheCalibrationOfItsSensor)
{
    Esp32Bench bench;
    bench.run(Seconds(0.5));
    EXPECT_EQ(bench.mount().condition(), QString());
    bench.box().faults().digits = {1, 3, 2, 0};
    bench.run(Seconds(2.0));
    EXPECT_TRUE(
        bench.mount().condition().contains(QStringLiteral("system 1, gyroscope 3, accelerometer 2, magnetometer 0")));
}

// REQ-GS232-83
TEST(Esp32Mount, StaysWhereItWasStopped)
{
    Esp32Bench bench;
    bench.run(Seconds(1.0));
    ASSERT_TRUE(bench.goTo(90.0, 60.0));
    bench.run(Seconds(6.0));
    ASSERT_FALSE(bench.stands(Seconds(2.0)));
    ASSERT_TRUE(bench.ask(request::Stop{}));
    const AxisPosition stopped = bench.truth();
    bench.run(Seconds(2.0));
    bench.expectAt(stopped, stopped, 2_deg);
    EXPECT_TRUE(bench.stands(Seconds(10.0)));
}

// REQ-GS232-83
TEST(Esp32Mount, TheEndOfTheProgramOverwritesTheTarget)
{
    Esp32Bench bench;
    bench.run(Seconds(1.0));
    ASSERT_TRUE(bench.goTo(90.0, 60.0));
    bench.run(Seconds(6.0));
    bench.mount().leave(profile::OnExit::Hold);
    bench.box().take(bench.mount().send(), bench.clock().now());
    bench.setLine(false);
    const AxisPosition left = bench.truth();
    bench.run(Seconds(2.0));
    bench.expectAt(left, left, 2_deg);
    EXPECT_TRUE(bench.stands(Seconds(10.0)));
}

// REQ-GS232-88: An ESP32 relay controller reports a heading and does not know its cable wrap. So a travel of more than
// 350° is refused. The refusal names the keys. A travel below 0° is accepted.
TEST(Esp32Mount, ATravelWithoutAGapIsRefused)
{
    profile::Profile profile = esp32Profile();
    profile.azimuth.geometry.travel = {.min = 0_deg, .max = 360_deg};
    Esp32Bench wide(profile);
    wide.run(Seconds(1.0));
    const Result<> refused = wide.goTo(60.0, 45.0);
    ASSERT_FALSE(refused);
    EXPECT_TRUE(refused.error().text.contains(QStringLiteral("azimuth.travel_min_deg")));
    EXPECT_FALSE(wide.ordered());

    profile.azimuth.geometry.travel = profile.limits.azimuth = {.min = -175_deg, .max = 175_deg};
    Esp32Bench folded(profile);
    folded.run(Seconds(1.0));
    ASSERT_TRUE(folded.goTo(-40.0, 45.0));
    folded.run(Seconds(25.0));
    folded.expectAt({.azimuth = -40_deg, .elevation = 45_deg}, {}, folded.resolution());
    EXPECT_EQ(folded.control().state(), StationState::Hold);
}

// REQ-GS232-89: An ESP32 relay controller that calibrates its sensor answers nothing else. The alarm shows its digits.
TEST(Esp32Mount, ACalibrationIsNamedInTheAlarm)
{
    Esp32Bench bench;
    bench.box().faults().digits = {0, 3, 1, 2};
    bench.box().restart(bench.clock().now(), false);
    bench.run(Seconds(6.0));
    const auto alarms = bench.control().status().alarms;
    EXPECT_TRUE(std::ranges::any_of(alarms, [](const Alarm& alarm) {
        return alarm.remedy.contains(QStringLiteral("system 0, gyroscope 3, accelerometer 1, magnetometer 2"));
    }));
    EXPECT_EQ(bench.mount().talk().proof(), RotatorTalk::Proof::Unknown);
    bench.box().faults().digits = {3, 3, 3, 3};
    bench.run(Seconds(3.0));
    EXPECT_EQ(bench.mount().kind(), QStringLiteral("ESP32"));
    EXPECT_TRUE(bench.goTo(60.0, 45.0));
}

// REQ-GS232-97: An ESP32 relay controller that restarts in a motion, with its twitch, reaches its target. While it
// stands, its twitch starts no motion.
TEST(Esp32Mount, ARestartWithItsTwitchIsNoMotion)
{
    Esp32Bench bench;
    bench.box().faults().twitches = true;
    bench.run(Seconds(1.0));
    ASSERT_TRUE(bench.goTo(60.0, 45.0));
    bench.run(Seconds(6.0));
    bench.box().restart(bench.clock().now());
    bench.run(Seconds(30.0));
    bench.expectAt({.azimuth = 60_deg, .elevation = 45_deg}, {}, bench.resolution());
    EXPECT_EQ(bench.control().state(), StationState::Hold);
    bench.box().restart(bench.clock().now());
    EXPECT_TRUE(bench.stands(Seconds(10.0)));
    EXPECT_FALSE(bench.control().faultLatched());
}

// REQ-GS232-98: A dance that somebody starts at an ESP32 relay controller is stopped again and again while STOP is
// latched, so that each of its steps moves an axis by a few degrees. Afterwards the mount stands.
TEST(Esp32Mount, ADanceIsStoppedWhileStopIsLatched)
{
    Esp32Bench bench;
    bench.run(Seconds(1.0));
    ASSERT_TRUE(bench.goTo(60.0, 45.0));
    bench.run(Seconds(25.0));
    ASSERT_TRUE(bench.ask(request::Stop{}));
    bench.run(Seconds(3.0));
    const AxisPosition before = bench.truth();
    bench.box().dance(bench.clock().now());
    Angle farthest;
    for (int i = 0; i < 70; ++i) {
        bench.run(Seconds(1.0));
        farthest = std::max(farthest, abs(bench.truth().azimuth - before.azimuth));
    }
    EXPECT_LT(farthest, 4_deg) << "its dance goes 30° far";
    bench.run(Seconds(8.0));
    EXPECT_TRUE(bench.stands(Seconds(10.0)));
}

// REQ-GS232-99: A GS-232 box in the place of an ESP32 relay controller gets only the question for the version, and
// never a command. It counts as a foreign device until Reconnect. An ESP32 relay controller in the place of a GS-232
// box is recognised, and a stop because of the lost line is all that it gets.
TEST(Esp32Mount, AnotherKindOfBoxOnItsLineIsNotCommanded)
{
    Esp32Bench bench;
    bench.run(Seconds(1.0));
    ASSERT_EQ(bench.mount().kind(), QStringLiteral("ESP32"));
    Gs232Mount& mount = bench.mount();
    Gs232Box other;
    mount.lineClosed();
    mount.lineOpened();
    for (int i = 0; i < 500; ++i) {
        bench.clock().advance(kOneTick);
        mount.take(other.answers(bench.clock().now()), bench.clock().now());
        mount.observe(bench.clock().now());
        (void)mount.supervise({});
        other.take(mount.send(), bench.clock().now());
    }
    EXPECT_TRUE(std::ranges::all_of(other.heard(), [](const std::string& line) { return line == "VE"; }));
    EXPECT_EQ(mount.talk().proof(), RotatorTalk::Proof::Foreign);
}

// REQ-GS232-99
TEST(Gs232Mount, AnEsp32OnItsLineIsRecognised)
{
    Gs232Bench bench;
    bench.run(Seconds(1.0));
    ASSERT_EQ(bench.mount().kind(), QStringLiteral("GS-232B"));
    Esp32Box other({.azimuth = 100_deg, .elevation = 20_deg});
    Gs232Mount& mount = bench.mount();
    mount.lineClosed();
    mount.lineOpened();
    for (int i = 0; i < 200; ++i) {
        bench.clock().advance(kOneTick);
        mount.take(other.answers(bench.clock().now()), bench.clock().now());
        mount.observe(bench.clock().now());
        (void)mount.supervise({});
        other.take(mount.send(), bench.clock().now());
    }
    EXPECT_EQ(mount.kind(), QStringLiteral("ESP32"));
    const AxisPosition there = other.truth();
    EXPECT_EQ(there.azimuth, 100_deg);
    EXPECT_EQ(there.elevation, 20_deg);
    EXPECT_EQ(other.heard()[0], "C2");
    EXPECT_EQ(other.heard()[1], "VE");
}

}  // namespace
}  // namespace boresight::gs232
