// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232_mount/switched_motor.h"

#include <gtest/gtest.h>

namespace boresight::gs232 {
namespace {

using std::chrono::seconds;

constexpr int kMost = 6;

// REQ-GS232-36: What is sent to a motor that runs costs no start. To turn it round does, and to start it again after it
// arrived, was stopped or stands.
TEST(SwitchedMotor, StartsAreCounted)
{
    SteadyTime now = SteadyTime{} + std::chrono::hours(1);
    SwitchedMotor motor;
    motor.send(10_deg, 10_deg, now);
    EXPECT_EQ(motor.starts(now).total, 0U) << "it is there";
    motor.send(10_deg, 50_deg, now);
    motor.send(20_deg, 90_deg, now += seconds(2));
    EXPECT_EQ(motor.starts(now).total, 1U) << "it runs on";
    motor.send(30_deg, 25_deg, now += seconds(2));
    EXPECT_EQ(motor.starts(now).total, 2U) << "it turns round";
    motor.observe(26_deg, true, now += seconds(1));
    EXPECT_FALSE(motor.runs()) << "it arrived";
    motor.send(25_deg, 60_deg, now);
    motor.stop();
    motor.send(30_deg, 60_deg, now += seconds(1));
    EXPECT_EQ(motor.starts(now).total, 4U);
    motor.observe(30_deg, false, now += seconds(1));
    EXPECT_TRUE(motor.runs()) << "its place has not changed yet";
    motor.observe(30_deg, false, now += seconds(1));
    EXPECT_FALSE(motor.runs()) << "it stands";
    EXPECT_EQ(motor.starts(now).lastMinute, 4);
    EXPECT_EQ(motor.starts(now + seconds(57)).lastMinute, 1);
    EXPECT_EQ(motor.starts(now + seconds(60)).lastMinute, 0);
    EXPECT_EQ(motor.starts(now + seconds(60)).total, 4U);
}

// REQ-GS232-31
TEST(SwitchedMotor, StartsOfAMinuteAreLimitedAndSpread)
{
    SteadyTime now = SteadyTime{} + std::chrono::hours(1);
    SwitchedMotor motor;
    Angle place = 10_deg;
    int most = 0;
    Seconds longest{0.0};
    SteadyTime last = now;
    for (int second = 0; second < 300; ++second, now += seconds(1)) {
        motor.stop();
        if (motor.maySend(place, place + 5_deg, kMost, now)) {
            motor.send(place, place + 5_deg, now);
            longest = std::max(longest, Seconds(now - last));
            last = now;
        }
        EXPECT_TRUE(motor.maySend(place, place, kMost, now)) << "it costs nothing";
        most = std::max(most, motor.starts(now).lastMinute);
    }
    EXPECT_EQ(most, kMost);
    EXPECT_LE(longest, Seconds(30.0));
    motor.send(place, place + 50_deg, now);
    EXPECT_TRUE(motor.maySend(place, place + 90_deg, kMost, now)) << "it runs";
}

}  // namespace
}  // namespace boresight::gs232
