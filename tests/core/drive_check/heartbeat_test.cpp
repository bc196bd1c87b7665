// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive_check/heartbeat.h"

#include "core/moteus/diagnostic.h"
#include "core/moteus/scaling.h"

#include <gtest/gtest.h>

namespace boresight::drive_check {
namespace {

using namespace std::chrono_literals;

class HeartbeatTest : public testing::Test
{
protected:
    // One query at this time, and a reply with this uptime of the drive's own counter.
    void beat(std::chrono::milliseconds at, std::int64_t uptime)
    {
        ASSERT_TRUE(heart.frame(start + at));
        const auto counter = static_cast<std::uint32_t>(0x80000000 - 300000 + uptime);
        moteus::Reply reply{.source = 3, .destination = moteus::kDiagnosticHostId};
        reply.values.push_back({moteus::Register::MillisecondCounter, moteus::Resolution::Int32,
                                moteus::fromWire(counter, moteus::Kind::Counter, moteus::Resolution::Int32)});
        heart.take(reply);
    }

    SteadyTime start{10h};
    Heartbeat heart{3};
};

constexpr std::int64_t kWrap = std::int64_t{1} << 32;

// REQ-SURVEY-10 (HeartbeatTest.*)
TEST_F(HeartbeatTest, TellsWhenTheDriveWasSwitchedOn)
{
    beat(0ms, 5000);
    EXPECT_EQ(heart.bootedAt(), start - 5s);
    beat(1000ms, 6003);
    EXPECT_EQ(heart.bootedAt(), start - 5s) << "does not move with the jitter of the answers";
}

TEST_F(HeartbeatTest, AsksOnceASecondAndSoonerWhileUnanswered)
{
    EXPECT_TRUE(heart.frame(start));
    EXPECT_FALSE(heart.frame(start + 80ms));
    EXPECT_TRUE(heart.frame(start + 100ms));
    EXPECT_EQ(heart.silences(), 2);
    beat(200ms, 5000);
    EXPECT_FALSE(heart.frame(start + 1180ms));
    EXPECT_TRUE(heart.frame(start + 1200ms));
}

TEST_F(HeartbeatTest, SignedOverflowAndTheEndOfTheCounterAreNoPowerUp)
{
    beat(0ms, 299500);
    beat(1000ms, 300500);  // from the most positive to the most negative number
    beat(2000ms, 301500);
    EXPECT_EQ(heart.reboots(), 0);
    heart = Heartbeat(3);
    beat(0ms, kWrap - 500);
    beat(1000ms, kWrap + 500);
    EXPECT_EQ(heart.reboots(), 0);
    EXPECT_EQ(heart.bootedAt(), start + 500ms - std::chrono::milliseconds(kWrap)) << "49 days ago";
}

TEST_F(HeartbeatTest, AnUptimeThatWentBackIsAPowerUp)
{
    beat(0ms, 5000);
    EXPECT_TRUE(heart.isAnswered());
    beat(1000ms, 200);
    EXPECT_FALSE(heart.isAnswered()) << "asked once more";
    EXPECT_EQ(heart.reboots(), 0);
    beat(1100ms, 300);
    EXPECT_TRUE(heart.isAnswered());
    EXPECT_EQ(heart.reboots(), 1);
    EXPECT_EQ(heart.bootedAt(), start + 800ms);
    beat(2100ms, 1300);
    EXPECT_EQ(heart.reboots(), 1);
}

// Story: after each suspend of the computer both wraps were unknown, although the drives had kept their power.
TEST_F(HeartbeatTest, ASuspendIsNoPowerUp)
{
    beat(0ms, 3'600'000);
    beat(20s, 3'620'150);  // the steady clock continues while the computer sleeps
    EXPECT_EQ(heart.reboots(), 0);
    beat(8h, 3'620'150 + 28'900'000);
    EXPECT_EQ(heart.reboots(), 0);
}

TEST_F(HeartbeatTest, APowerUpDuringASuspendIsNoticed)
{
    beat(0ms, 3'600'000);
    beat(8h, 28'700'000);
    beat(8h + 1s, 28'701'000);
    EXPECT_EQ(heart.reboots(), 1);
}

// 8 h are counted with an error of up to 10 min, so this could be a drive that was power-cycled.
TEST_F(HeartbeatTest, AfterALongSilenceADriveThatWasOnOnlyShortlyProvesNothing)
{
    beat(0ms, 300'000);
    beat(8h, 300'000 + 28'800'000);
    beat(8h + 1s, 300'000 + 28'801'000);
    EXPECT_EQ(heart.reboots(), 1);
}

// The clock of the drive is 2 % fast, so by its count alone it could have been on all the time.
TEST_F(HeartbeatTest, ADriveWithAFastClockProvesNothingMoreThanAnother)
{
    beat(0ms, 580'000);
    beat(8h, 29'370'000);  // it was power-cycled right after the first reply
    beat(8h + 1s, 29'371'000);
    EXPECT_EQ(heart.reboots(), 1);
}

// A short time after the overflow of its counter a drive seems to have just been switched on. Without a long silence
// the count is enough.
TEST_F(HeartbeatTest, ASampleRightAfterTheEndOfTheCounterIsNoPowerUp)
{
    for (const std::int64_t uptime : {0, 10, 20}) {
        heart = Heartbeat(3);
        beat(0ms, kWrap - 990);
        beat(1000ms, kWrap + uptime);
        beat(2000ms, kWrap + uptime + 1000);
        EXPECT_TRUE(heart.isAnswered()) << uptime;
        EXPECT_EQ(heart.reboots(), 0) << uptime;
    }
}

// After a long silence the count of such a drive proves nothing. It counts as power-cycled, which is the safe side.
TEST_F(HeartbeatTest, ALongSilenceRightAfterTheEndOfTheCounterIsAPowerUp)
{
    beat(0ms, kWrap + 10'000);
    beat(1h, kWrap + 3'610'000);
    beat(1h + 1s, kWrap + 3'611'000);
    EXPECT_EQ(heart.reboots(), 1);
}

// The drive was switched off right after the last reply before the overflow, and has been on since. Modulo the overflow
// its count is the elapsed time.
TEST_F(HeartbeatTest, APowerUpThatLooksLikeTheEndOfTheCounterIsNoticed)
{
    beat(0ms, kWrap - 500);
    beat(1h, 3'599'000);
    beat(1h + 1s, 3'600'000);
    EXPECT_EQ(heart.reboots(), 1);
}

// Story: an old reply that arrived again was taken for a power-up, and the drive check after it cost a pass.
TEST_F(HeartbeatTest, OneFalseUptimeIsNoPowerUp)
{
    beat(0ms, 5000);
    beat(1000ms, 3500);
    beat(1100ms, 6100);
    EXPECT_TRUE(heart.isAnswered());
    beat(2100ms, 700);
    beat(2200ms, 700);
    beat(2300ms, 4000000);
    beat(2400ms, 7400);
    EXPECT_TRUE(heart.isAnswered());
    EXPECT_EQ(heart.reboots(), 0);
    EXPECT_EQ(heart.bootedAt(), start - 5000ms);
}

// The two values are half the range of the counter apart: 30 days of uptime, then a power-up.
TEST_F(HeartbeatTest, AlsoAfterWeeks)
{
    beat(0ms, std::int64_t{30} * 24 * 3600 * 1000);
    beat(1000ms, 300);
    beat(1100ms, 400);
    EXPECT_EQ(heart.reboots(), 1);
}

TEST_F(HeartbeatTest, AClockThatDriftsIsNoPowerUp)
{
    beat(0ms, 3'600'000);
    beat(600s, 3'600'000 + 591'000);  // 1.5 % in ten minutes without a reply
    EXPECT_TRUE(heart.isAnswered());
    EXPECT_EQ(heart.reboots(), 0);
}

TEST_F(HeartbeatTest, AnotherBoardIsNoPowerUp)
{
    heart.begin({1, 2, 3, 4});
    beat(0ms, 5000);
    heart.begin({1, 2, 3, 5});
    beat(1000ms, 200);
    EXPECT_EQ(heart.reboots(), 0);
    EXPECT_EQ(heart.bootedAt(), start + 800ms);
}

TEST_F(HeartbeatTest, WhatOthersSayDoesNotCount)
{
    EXPECT_FALSE(heart.isAnswered()) << "before it asked";
    EXPECT_TRUE(heart.frame(start));
    moteus::Reply reply{.source = 4, .destination = moteus::kDiagnosticHostId};
    reply.values.push_back({moteus::Register::MillisecondCounter, moteus::Resolution::Int32, 1000.0});
    heart.take(reply);
    EXPECT_FALSE(heart.isAnswered());
}

}  // namespace
}  // namespace boresight::drive_check
