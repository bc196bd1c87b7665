// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232_mount/switched_motor.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace boresight::gs232 {
namespace {

using std::chrono::seconds;
using Act = SwitchedMotor::Act;

class SwitchedMotorTest : public testing::Test
{
protected:
    SteadyTime now = SteadyTime{} + std::chrono::hours(1);
    SwitchedMotor motor;

    void standAt(double degrees)
    {
        motor.place(Angle::fromDegrees(degrees), now);
        motor.place(Angle::fromDegrees(degrees), now += seconds(2));
        motor.beginHere();
        ASSERT_TRUE(motor.stands());
    }
    void send(double to) { motor.sent(Angle::fromDegrees(to), Angle::fromDegrees(to), now); }
    void showAfter(seconds time, double degrees) { motor.place(Angle::fromDegrees(degrees), now += time); }
    [[nodiscard]] SwitchedMotor::Decision toPlace(double end, int most = 10) const
    {
        return motor.decide({.end = Angle::fromDegrees(end), .target = {}, .most = most}, now);
    }
    [[nodiscard]] SwitchedMotor::Decision following(double target, double end, double slack) const
    {
        return motor.decide({.end = Angle::fromDegrees(end),
                             .target = Angle::fromDegrees(target),
                             .follows = true,
                             .slack = Angle::fromDegrees(slack),
                             .most = 10},
                            now);
    }
};

SwitchedMotor::Decision go(double to)
{
    return {.act = Act::Go, .to = Angle::fromDegrees(to)};
}

void expectGo(const SwitchedMotor::Decision& decision, double to)
{
    EXPECT_EQ(decision.act, go(to).act);
    EXPECT_NEAR(decision.to.degrees(), to, 1e-6);
}

// REQ-GS232-33
TEST_F(SwitchedMotorTest, APlaceIsMetOnce)
{
    standAt(10);
    EXPECT_EQ(toPlace(10).act, Act::Stay);
    expectGo(toPlace(11), 11);
    expectGo(toPlace(8), 8);
    send(20);
    showAfter(seconds(2), 18);
    EXPECT_EQ(toPlace(20).act, Act::Stay) << "it runs";
    showAfter(seconds(1), 18);
    showAfter(seconds(1), 18);
    EXPECT_TRUE(motor.stands()) << "two degrees short";
    EXPECT_EQ(toPlace(20).act, Act::Stay) << "it cannot do better";
    expectGo(toPlace(21), 21);
}

// REQ-GS232-33
TEST_F(SwitchedMotorTest, ALongWayIsOneStartInPieces)
{
    standAt(10);
    expectGo(toPlace(90), 22);
    motor.sent(22_deg, 90_deg, now);
    showAfter(seconds(0), 13);
    EXPECT_EQ(toPlace(90).act, Act::Stay);
    showAfter(seconds(1), 15);
    expectGo(toPlace(90), 27);
    motor.sent(27_deg, 90_deg, now);
    EXPECT_EQ(motor.starts(), 1U);
    showAfter(seconds(1), 23);
    EXPECT_EQ(toPlace(90).act, Act::Stay) << "it may have stopped already, and the start would be counted nowhere";
}

// Story: a piece of the way ended two degrees before the place, which counted as reached.
TEST_F(SwitchedMotorTest, TheEndOfAPieceIsNoArrival)
{
    standAt(10);
    motor.sent(22_deg, 24_deg, now);
    showAfter(seconds(1), 22);
    showAfter(seconds(2), 22);
    ASSERT_TRUE(motor.stands());
    EXPECT_FALSE(motor.isAt(24_deg));
    expectGo(toPlace(24), 24);
}

// REQ-GS232-34
TEST_F(SwitchedMotorTest, IsStoppedBeforeItTurnsRound)
{
    standAt(50);
    send(60);
    showAfter(seconds(1), 54);
    for (const double end : {20.0, 50.0, 53.0, 54.0}) {
        EXPECT_EQ(toPlace(end, 1).act, Act::Stop) << end;
    }
    expectGo(toPlace(57, 1), 57);
    motor.stopped(now);
    EXPECT_EQ(toPlace(20, 1).act, Act::Stay) << "it coasts";
    showAfter(seconds(1), 56);
    showAfter(seconds(1), 56);
    EXPECT_EQ(toPlace(20, 1).act, Act::Wait);
    expectGo(toPlace(20, 2 * 4), 44);
}

// REQ-GS232-31: What moves is left alone until it is a dead band away. The dead band is the slack less one degree, and
// no less than one degree and the coast.
TEST_F(SwitchedMotorTest, WhatMovesHasADeadBand)
{
    standAt(100);
    EXPECT_EQ(motor.deadBand(4_deg), 3_deg);
    EXPECT_EQ(motor.deadBand({}), 1_deg);
    EXPECT_EQ(following(102.9, 106, 4).act, Act::Stay);
    expectGo(following(103.2, 107, 4), 107);
    expectGo(following(96.5, 93, 4), 93);
    motor.sent(107_deg, 107_deg, now);
    showAfter(seconds(1), 105);
    EXPECT_EQ(following(104.5, 108, 4).act, Act::Stay) << "it arrives";
    expectGo(following(103.0, 106, 4), 106);
    EXPECT_EQ(following(101.0, 104, 4).act, Act::Stop) << "beyond its end may be forbidden";
    EXPECT_EQ(following(90.0, 94, 4).act, Act::Stop);
}

// REQ-GS232-32
TEST_F(SwitchedMotorTest, StopsEarlierByItsCoast)
{
    standAt(0);
    double rest = 0;
    for (int move = 0; move < 8; ++move) {
        const auto decision = toPlace(rest + 10);
        ASSERT_EQ(decision.act, Act::Go);
        motor.sent(decision.to, Angle::fromDegrees(rest + 10), now);
        const double to = decision.to.degrees();
        showAfter(seconds(1), to);
        showAfter(seconds(1), to + 2);
        showAfter(seconds(2), to + 2);
        ASSERT_TRUE(motor.stands());
        rest = std::round(to + 2);
        now += seconds(60);
        motor.beginHere();
    }
    EXPECT_NEAR(motor.coast().degrees(), 2.0, 0.1);
    expectGo(toPlace(rest + 10), rest + 8);
    expectGo(toPlace(rest + 1), rest + 1);
    EXPECT_GE(motor.deadBand({}), motor.coast());
}

// REQ-GS232-35
TEST_F(SwitchedMotorTest, StartsAreCountedByOrderAndByEye)
{
    standAt(10);
    send(10);
    EXPECT_EQ(motor.starts(), 0U) << "it is there";
    send(50);
    send(90);
    EXPECT_EQ(motor.starts(), 1U) << "it runs on";
    motor.stopped(now);
    showAfter(seconds(1), 14);
    showAfter(seconds(2), 15);
    showAfter(seconds(1), 15);
    EXPECT_EQ(motor.starts(), 1U) << "it coasts";
    for (int flicker = 0; flicker < 10; ++flicker) {
        showAfter(seconds(1), flicker % 2 == 0 ? 16 : 15);
    }
    EXPECT_EQ(motor.starts(), 1U);
    EXPECT_TRUE(motor.stands());
    showAfter(seconds(1), 17);
    EXPECT_EQ(motor.starts(), 2U) << "nobody here has ordered that";
    EXPECT_FALSE(motor.stands());
    EXPECT_EQ(toPlace(90).act, Act::Stay) << "somebody else moves it";
    showAfter(seconds(1), 25);
    showAfter(seconds(2), 25);
    EXPECT_EQ(motor.starts(), 2U);
    EXPECT_EQ(motor.startsInLastMinute(now), 2);
    EXPECT_EQ(motor.startsInLastMinute(now + seconds(60)), 0);
    motor.forget();
    EXPECT_EQ(motor.starts(), 2U) << "of another line, too";
}

// REQ-GS232-30
TEST_F(SwitchedMotorTest, StartsOfAMinuteAreLimitedAndSpread)
{
    for (const int most : {1, 2, 4, 10, 60}) {
        SwitchedMotor one;
        one.place(0_deg, now);
        int worst = 0;
        Seconds longest{0.0};
        SteadyTime last = now;
        for (int tick = 0; tick < 1200; ++tick) {
            now += std::chrono::milliseconds(500);
            const Angle place = tick % 2 == 0 ? 0_deg : 5_deg;
            one.stopped(now - seconds(2));
            one.place(place, now);
            one.place(place, now + seconds(1));
            const auto decision = one.decide({.end = 20_deg, .target = {}, .most = most}, now);
            if (decision.act == Act::Go) {
                one.sent(decision.to, 20_deg, now);
                longest = std::max(longest, Seconds(now - last));
                last = now;
            }
            worst = std::max(worst, one.startsInLastMinute(now));
        }
        EXPECT_LE(worst, most);
        EXPECT_GE(4 * worst, 3 * most);
        EXPECT_LE(longest, Seconds(60.0) / most + Seconds(16.0)) << most;
    }
}

// REQ-GS232-36
TEST_F(SwitchedMotorTest, TellsWhenItMustNotBeNamed)
{
    standAt(10);
    EXPECT_FALSE(motor.ends());
    send(20);
    EXPECT_FALSE(motor.ends());
    showAfter(seconds(1), 17);
    EXPECT_TRUE(motor.ends());
    showAfter(seconds(1), 20);
    EXPECT_FALSE(motor.runs());
    EXPECT_TRUE(motor.ends());
    showAfter(seconds(2), 20);
    EXPECT_FALSE(motor.ends());
}

// REQ-GS232-37: An axis counts as being on the way that it was sent, if it is there within its miss. Else it is where
// it is.
TEST_F(SwitchedMotorTest, CountsAsBeingOnItsWay)
{
    standAt(10);
    send(20);
    showAfter(seconds(1), 8);
    EXPECT_EQ(motor.believed(), 10_deg);
    showAfter(seconds(1), 15);
    EXPECT_EQ(motor.believed(), 15_deg);
    showAfter(seconds(1), 22);
    EXPECT_EQ(motor.believed(), 20_deg);
    showAfter(seconds(1), 24);
    EXPECT_EQ(motor.believed(), 24_deg);
    EXPECT_FALSE(motor.overran());
    showAfter(seconds(1), 27);
    EXPECT_TRUE(motor.overran());
}

}  // namespace
}  // namespace boresight::gs232
