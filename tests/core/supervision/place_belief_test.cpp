// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/supervision/place_belief.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace boresight::supervision {
namespace {

constexpr double kTick = 0.02;

MotorTurns degrees(double value)
{
    return MotorTurns::fromTurns(value / 360.0);
}

// A drive that is queried every 20 ms and replies a millisecond later. In degrees, at most 10°/s.
class PlaceBeliefTest : public ::testing::Test
{
protected:
    void reply(std::optional<double> place, double period = kTick)
    {
        now += std::chrono::duration_cast<SteadyTime::duration>(Seconds(period));
        belief.take({.asked = now,
                     .received = now + std::chrono::milliseconds(1),
                     .place = place ? std::optional(degrees(*place)) : std::nullopt});
    }
    void replies(int count)
    {
        for (int i = 0; i < count; ++i) {
            at += rate * kTick;
            reply(at);
        }
    }
    [[nodiscard]] std::optional<double> place() const
    {
        return belief.place() ? std::optional(belief.place()->position.turns() * 360.0) : std::nullopt;
    }

    PlaceBelief belief{{.allowance = degrees(0.5), .speed = degrees(10.0) / Seconds(1.0)}};
    SteadyTime now{std::chrono::hours(1)};
    double at = 100.0;
    double rate = 0.0;
};

// Story: after the bus was taken back five replies in a row had the same false position. The drive was still on, and
// was commanded to hold there.
// REQ-SUPERVISION-15: A position is believed if the axis can have got there since the last believed position. Otherwise
// it is doubted, until six replies in a row agree with each other: then the angle has jumped. A first position also
// needs six such replies.
TEST_F(PlaceBeliefTest, TheFirstPlaceIsBelievedWhenSixRepliesAgree)
{
    reply(100.0);
    EXPECT_FALSE(place());
    for (int i = 0; i < 5; ++i) {
        reply(190.0);
        EXPECT_FALSE(place());
    }
    for (int i = 0; i < 5; ++i) {
        reply(100.0 + i / 100.0);
        EXPECT_FALSE(place());
    }
    reply(100.05);
    EXPECT_NEAR(*place(), 100.05, 1e-9);
    EXPECT_TRUE(belief.believedLast());
    EXPECT_FALSE(belief.takeJump()) << "there was no place to jump from";
}

// REQ-SUPERVISION-15
TEST_F(PlaceBeliefTest, AFalseReplyIsNotBelievedAndIsTold)
{
    for (const double speed : {0.0, 10.0, -10.0}) {
        for (const double by : {90.0, -90.0, 1.0, -1.0, 2.0, -2.0, 360.0}) {
            rate = speed;
            belief.forget();
            replies(50);
            const double before = *place();
            at += rate * kTick;
            reply(at + by);
            EXPECT_NEAR(*place(), before, 1e-9) << speed << " " << by;
            EXPECT_FALSE(belief.believedLast());
            EXPECT_FALSE(belief.takeFalsePlace());
            replies(1);
            EXPECT_NEAR(*place(), at, 1e-9) << speed << " " << by;
            EXPECT_TRUE(belief.believedLast());
            const auto told = belief.takeFalsePlace();
            ASSERT_TRUE(told) << speed << " " << by;
            EXPECT_NEAR((told->to - told->from).turns() * 360.0, by, 0.01);
            EXPECT_FALSE(belief.takeJump());
        }
    }
}

// REQ-SUPERVISION-15
TEST_F(PlaceBeliefTest, PlacesThatDoNotAgreeAreNeverBelieved)
{
    replies(10);
    for (int i = 0; i < 100; ++i) {
        reply(i % 2 == 0 ? 190.0 : 10.0);
    }
    EXPECT_FALSE(place()) << "too old";
    EXPECT_FALSE(belief.takeJump());
    replies(PlaceBelief::kAgree);
    EXPECT_NEAR(*place(), 100.0, 1e-9) << "it still stands there";
    EXPECT_FALSE(belief.takeJump());
}

// REQ-SUPERVISION-15
TEST_F(PlaceBeliefTest, EverySecondReplyMayBeFalse)
{
    rate = 7.0;
    replies(50);
    for (int i = 0; i < 200; ++i) {
        at += rate * kTick;
        reply(at + 90.0);
        replies(1);
        ASSERT_NEAR(*place(), at, 1e-9);
    }
    EXPECT_FALSE(belief.takeJump());
}

// Story: a slip of 2° during a slew was within the tolerance for late replies.
// REQ-SUPERVISION-16: A slip of 1° between two replies is a jump, in either direction and at any speed up to 10°/s.
TEST_F(PlaceBeliefTest, ASlipOfOneDegreeIsAJumpAtAnySpeed)
{
    for (const double speed : {0.0, 1.0, 5.0, 10.0, -10.0}) {
        for (const double slip : {1.0, -1.0, 2.0, -2.0, 90.0}) {
            rate = speed;
            belief.forget();
            replies(50);
            at += slip;
            replies(PlaceBelief::kJump);
            const auto jump = belief.takeJump();
            ASSERT_TRUE(jump) << speed << " " << slip;
            EXPECT_NEAR((jump->to - jump->from).turns() * 360.0, slip, 0.05) << speed << " " << slip;
            EXPECT_NEAR(*place(), at, 1e-9);
            replies(100);
            EXPECT_FALSE(belief.takeJump()) << "told once";
        }
    }
}

// The axis hits something hard and its encoder slips: two degrees are more than the stop explains.
TEST_F(PlaceBeliefTest, ASlipOfTwoDegreesJustAfterAHardStopIsAJump)
{
    for (const double slip : {2.0, -2.0}) {
        for (int standing = 0; standing < 8; ++standing) {
            belief.forget();
            rate = 10.0;
            replies(50);
            rate = 0.0;
            replies(standing);
            at += slip;
            replies(2 * PlaceBelief::kJump);
            EXPECT_TRUE(belief.takeJump()) << slip << " after " << standing;
        }
    }
}

TEST_F(PlaceBeliefTest, ASlipOfTwoDegreesIsAJumpWithRepliesLostOrFalseAfterIt)
{
    for (const double speed : {0.0, 10.0}) {
        for (const double slip : {2.0, -2.0}) {
            for (const std::optional<double> other : {std::optional<double>(), std::optional(40.0)}) {
                for (const int others : {1, 2}) {
                    belief.forget();
                    rate = speed;
                    replies(50);
                    at += slip;
                    replies(1);
                    for (int i = 0; i < others; ++i) {
                        at += rate * kTick;
                        reply(other);
                    }
                    replies(2 * PlaceBelief::kJump);
                    EXPECT_TRUE(belief.takeJump()) << slip << " at " << speed << ", then " << others;
                }
            }
        }
    }
}

// REQ-SUPERVISION-18: After three replies in a row without a believed position the next position needs three replies
// that agree. One other reply between two of them is allowed. After 0.2 s without a believed position there is no
// position.
TEST_F(PlaceBeliefTest, ADriveWithoutAPlaceHasNoneAfterAFifthOfASecond)
{
    replies(10);
    for (int i = 0; i < 9; ++i) {
        reply({});
        EXPECT_FALSE(belief.believedLast());
    }
    EXPECT_TRUE(place());
    reply({});
    EXPECT_FALSE(place());
    for (int i = 0; i < PlaceBelief::kAgree; ++i) {
        EXPECT_FALSE(place()) << i;
        reply(100.1);
    }
    EXPECT_NEAR(*place(), 100.1, 1e-9);
    for (int i = 0; i < 10; ++i) {
        reply({});
    }
    for (int i = 1; i < PlaceBelief::kJump; ++i) {
        reply(120.0);
    }
    EXPECT_FALSE(place());
    reply(120.0);
    EXPECT_TRUE(belief.takeJump()) << "farther than it can have gone meanwhile";
}

// Story: one of ten replies was false. Two in a row, each with an error too small to be doubted, were believed. Then
// the true replies counted as a jump.
// REQ-SUPERVISION-19: A reply that continues the path of one of the last four believed positions is believed. So one or
// two replies with an error too small to be doubted do no harm.
TEST_F(PlaceBeliefTest, AfterTwoRepliesThatAreFalseByLittleTheTrueOnesAreBelieved)
{
    for (const double speed : {0.0, -2.0, 10.0}) {
        rate = speed;
        belief.forget();
        replies(50);
        for (const double by : {0.45, 0.7}) {
            at += rate * kTick;
            reply(at + by);
        }
        EXPECT_NEAR(*place(), at + 0.7, 1e-9) << "it can have got there";
        for (int i = 0; i < 20; ++i) {
            replies(1);
            EXPECT_NEAR(*place(), at, 1e-9) << speed << " " << i;
        }
    }
}

// Story: one of ten replies was false. Three in a row left the axis without a position. Then single false replies kept
// it so, and the drive counted as blind.
// REQ-SUPERVISION-18
TEST_F(PlaceBeliefTest, AfterThreeRepliesWithoutAPlaceOneMoreDoesNotBreakTheRow)
{
    for (const std::optional<double> between : {std::optional<double>(), std::optional(-250.0)}) {
        belief.forget();
        replies(10);
        for (int i = 0; i < 3; ++i) {
            reply({});
        }
        replies(1);
        reply(between);
        replies(1);
        EXPECT_FALSE(belief.believedLast()) << "two agree";
        reply(between);
        replies(1);
        EXPECT_TRUE(belief.believedLast());
        EXPECT_FALSE(belief.takeJump());
    }
}

// After replies without a position the axis can have moved by two degrees, and every second reply claims this.
TEST_F(PlaceBeliefTest, AFalsePlaceThatAlternatesWithTheTrueOneIsNotBelieved)
{
    for (const bool falseFirst : {true, false}) {
        belief.forget();
        replies(10);
        for (int i = 0; i < 8; ++i) {
            reply({});
        }
        for (int i = 0; i < 100; ++i) {
            reply((i % 2 == 0) == falseFirst ? at + 2.0 : at);
            EXPECT_FALSE(belief.believedLast()) << falseFirst << " " << i;
        }
        EXPECT_FALSE(place());
        replies(PlaceBelief::kAgree + 1);  // the first may be skipped
        ASSERT_TRUE(place());
        EXPECT_NEAR(*place(), at, 1e-9);
        EXPECT_FALSE(belief.takeJump());
    }
}

TEST_F(PlaceBeliefTest, WhatIsForgottenIsNoJump)
{
    replies(10);
    belief.forget();
    EXPECT_FALSE(place());
    at = 300.0;
    replies(PlaceBelief::kJump);
    EXPECT_NEAR(*place(), 300.0, 1e-9);
    belief.expectAnother();
    EXPECT_TRUE(place());
    at = 200.0;
    replies(PlaceBelief::kJump);
    EXPECT_NEAR(*place(), 200.0, 1e-9);
    EXPECT_FALSE(belief.takeJump());
    EXPECT_FALSE(belief.takeFalsePlace());
}

// A late reply, or one with a small error, may be believed or not. The true replies after it are believed.
// REQ-SUPERVISION-17
TEST_F(PlaceBeliefTest, AReplyThatIsALittleOffIsNoJump)
{
    for (const double speed : {0.0, 3.0, 10.0, -10.0}) {
        for (double by = -1.5; by < 1.5; by += 0.05) {
            rate = speed;
            belief.forget();
            replies(50);
            at += rate * kTick;
            reply(at + by);
            replies(20);
            ASSERT_FALSE(belief.takeJump()) << speed << " " << by;
            ASSERT_NEAR(*place(), at, 1e-9) << speed << " " << by;
        }
    }
}

// REQ-SUPERVISION-17
TEST_F(PlaceBeliefTest, AnAxisThatIsStoppedAtOnceIsNotDoubted)
{
    for (const double speed : {2.0, 10.0, 60.0}) {
        belief.setLimits({.allowance = degrees(0.5), .speed = degrees(speed) / Seconds(1.0)});
        belief.forget();
        rate = speed;
        replies(50);
        rate = 0.0;
        replies(50);
        EXPECT_FALSE(belief.takeFalsePlace()) << speed;
        EXPECT_FALSE(belief.takeJump()) << speed;
        EXPECT_NEAR(*place(), at, 1e-9);
    }
}

// A value measured at `asked`, which Boresight receives at `arrives`.
struct Sample
{
    double asked;
    double arrives;
    double place;
};

// A motion with jerky starts and stops. The bus and the ticks that read it are late at random.
class HealthyAxis : public PlaceBeliefTest, public ::testing::WithParamInterface<double>
{
protected:
    [[nodiscard]] double speedAt(double time) const
    {
        const double fastest = GetParam();
        switch (static_cast<int>(time / 1.5) % 4) {
            case 0:
                return 0.0;
            case 1:
                return fastest;
            case 2:
                return -fastest;
            default:
                return 0.3 * fastest;
        }
    }

    // Speeds change by at most the emergency braking of a drive: from full speed to standstill in 0.08 s.
    [[nodiscard]] std::vector<double> placesEveryMillisecond() const
    {
        std::vector<double> places;
        double place = 100.0;
        double speed = 0.0;
        for (int i = 0; i < 60'000; ++i) {
            const double wanted = speedAt(0.001 * i);
            const double most = GetParam() / 0.08 * 0.001;
            speed += std::clamp(wanted - speed, -most, most);
            place += speed * 0.001;
            places.push_back(place);
        }
        return places;
    }
};

// REQ-SUPERVISION-17 (HealthyAxis.*): A healthy axis is never doubted: at full speed, in reversals at the full braking
// of a drive, at an obstacle, with replies up to 30 ms late, with ticks up to 0.12 s late, and with one reply in fifty
// lost.
TEST_P(HealthyAxis, IsNeverDoubted)
{
    belief.setLimits({.allowance = degrees(0.5), .speed = degrees(GetParam()) / Seconds(1.0)});
    const std::vector<double> places = placesEveryMillisecond();
    std::minstd_rand random(7);
    const auto chance = [&](double part) { return std::uniform_real_distribution(0.0, 1.0)(random) < part; };
    std::optional<double> asked;
    bool replied = true;
    std::vector<Sample> waiting;
    double time = 0.1;
    while (time < 59.0) {
        // As in Drive::judge(): the oldest query without a reply.
        asked = replied || !asked ? time : *asked;
        replied = false;
        const double latency = chance(0.02) ? 0.03 : std::uniform_real_distribution(0.0005, 0.008)(random);
        if (!chance(0.02)) {
            const double measured = time + std::uniform_real_distribution(0.0, latency)(random);
            waiting.push_back({time, time + latency, places[static_cast<std::size_t>(measured * 1000.0)]});
        }
        const double next =
            time + (chance(0.01) ? 0.12 : kTick + std::uniform_real_distribution(-0.004, 0.004)(random));
        while (!waiting.empty() && waiting.front().arrives < next) {
            // After a stall, replies get the time when they are read.
            const double stamp = next - time > 0.1 ? next - 0.0001 : waiting.front().arrives;
            const auto steady = [](double seconds) {
                return SteadyTime(std::chrono::duration_cast<SteadyTime::duration>(Seconds(seconds)));
            };
            belief.take({.asked = steady(*asked), .received = steady(stamp), .place = degrees(waiting.front().place)});
            ASSERT_FALSE(belief.takeFalsePlace()) << time;
            ASSERT_FALSE(belief.takeJump()) << time;
            ASSERT_TRUE(time < 0.3 || belief.believedLast()) << time;
            replied = true;
            waiting.erase(waiting.begin());
        }
        time = next;
    }
    EXPECT_TRUE(belief.place());
}

INSTANTIATE_TEST_SUITE_P(Speed, HealthyAxis, ::testing::Values(2.0, 10.0, 60.0));

}  // namespace
}  // namespace boresight::supervision
