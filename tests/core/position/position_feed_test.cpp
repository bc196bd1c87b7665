// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/position/position_feed.h"

#include "tests/fakes/manual_clock.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

namespace boresight::position {
namespace {

using namespace std::chrono_literals;

constexpr double kMetresOfADegree = 111'195.0;  // of latitude, near enough

class PositionFeedTest : public testing::Test
{
protected:
    PositionFeedTest() { feed.setLimits({.stale = Seconds(30.0), .fastest = 300.0}); }

    // The place this many metres north.
    [[nodiscard]] static PositionText north(double metres)
    {
        return {.site = {.latitude = Angle::fromDegrees(40.0 + metres / kMetresOfADegree),
                         .longitude = -9_deg,
                         .heightMetres = 10'000.0}};
    }
    std::string take(const Result<PositionText>& read)
    {
        const Result<> taken = feed.take(read, clock.now(), clock.utc());
        return taken ? std::string() : textOf(taken.error());
    }
    [[nodiscard]] double metresFrom(const PositionText& text) const
    {
        const orbit::Vector there = orbit::Observer(text.site).ground({}, 0.0);
        return length(feed.at(clock.now()).position - there) * 1000.0;
    }

    fakes::ManualClock clock;
    PositionFeed feed;
};

// REQ-POSITION-10: Between two reports the position continues with the motion from the previous report to the last one,
// for at most 10 s. Then it stays at the computed place.
TEST_F(PositionFeedTest, GoesOnAsBefore)
{
    EXPECT_EQ(take(north(0.0)), "");
    clock.advance(Seconds(5.0));
    EXPECT_LT(metresFrom(north(0.0)), 0.1) << "of one report no way follows";
    EXPECT_EQ(take(north(500.0)), "");
    clock.advance(Seconds(2.0));
    EXPECT_LT(metresFrom(north(700.0)), 2.0);
    EXPECT_NEAR(length(feed.at(clock.now()).velocity) * 1000.0, 100.0, 1.0);
    clock.advance(Seconds(20.0));
    EXPECT_LT(metresFrom(north(1500.0)), 4.0);
    EXPECT_EQ(length(feed.at(clock.now()).velocity), 0.0);
}

// A receiver sends when it can, and states the time of the measurement.
// REQ-POSITION-10
TEST_F(PositionFeedTest, TheTimesOfTheReportsCount)
{
    PositionText first = north(0.0);
    PositionText second = north(100.0);
    first.time = 0h + 5s;
    second.time = 0h + 6s;
    EXPECT_EQ(take(first), "");
    clock.advance(Seconds(0.4));
    EXPECT_EQ(take(second), "");
    EXPECT_NEAR(length(feed.at(clock.now()).velocity) * 1000.0, 100.0, 1.0);
}

// REQ-POSITION-11: A jump that needs a higher speed than the profile permits is refused, and changes nothing. After a
// silence any position is accepted as a new start.
TEST_F(PositionFeedTest, AJumpIsRefused)
{
    EXPECT_EQ(take(north(0.0)), "");
    clock.advance(Seconds(1.0));
    EXPECT_EQ(take(north(290.0)), "");
    clock.advance(Seconds(1.0));
    EXPECT_EQ(take(north(50'000.0)), "the position jumped by 49.7 km in 1.0 s");
    EXPECT_LT(metresFrom(north(580.0)), 3.0);
    EXPECT_EQ(feed.refused(), 1U);
    EXPECT_EQ(feed.accepted(), 2U);
    clock.advance(Seconds(29.5));
    EXPECT_FALSE(feed.isFresh(clock.now()));
    EXPECT_EQ(take(north(50'000.0)), "");
    EXPECT_LT(metresFrom(north(50'000.0)), 0.1);
    EXPECT_TRUE(feed.isFresh(clock.now()));
}

// REQ-POSITION-12: A report that arrives by two ways counts once.
TEST_F(PositionFeedTest, AnEchoChangesNothing)
{
    EXPECT_EQ(take(north(0.0)), "");
    clock.advance(Seconds(1.0));
    EXPECT_EQ(take(north(100.0)), "");
    clock.advance(Seconds(0.01));
    EXPECT_EQ(take(north(100.0)), "");
    EXPECT_NEAR(length(feed.at(clock.now()).velocity) * 1000.0, 100.0, 1.0);
}

// REQ-POSITION-15: A report that repeats the last one, or is older, changes neither the path nor the age.
TEST_F(PositionFeedTest, AnOldReportChangesNothing)
{
    clock.setUtc(UtcTime(std::chrono::days(20'000)));
    const auto timed = [](double metres, std::chrono::milliseconds time) {
        PositionText text = north(metres);
        text.time = time;
        return text;
    };
    EXPECT_EQ(take(timed(0.0, 23h + 59min + 58s)), "");
    clock.advance(Seconds(2.0));
    EXPECT_EQ(take(timed(200.0, 0s)), "");
    clock.advance(Seconds(2.0));
    EXPECT_EQ(take(timed(200.0, 0s)), "") << "sent again";
    EXPECT_EQ(take(timed(100.0, 23h + 59min + 59s)), "") << "overtaken, before midnight";
    EXPECT_LT(metresFrom(north(400.0)), 2.0);
    EXPECT_EQ(feed.age(clock.now()), Seconds(2.0));
    clock.advance(Seconds(30.0));
    EXPECT_EQ(take(timed(200.0, 0s)), "");
    EXPECT_FALSE(feed.isFresh(clock.now())) << "whoever sends the last one for ever is silent";
    EXPECT_EQ(take(timed(200.0, 32s)), "");
    EXPECT_TRUE(feed.isFresh(clock.now()));
}

// REQ-POSITION-15
TEST_F(PositionFeedTest, HalfADayLaterNoReportIsOld)
{
    PositionText text = north(0.0);
    text.time = 1h;
    clock.setUtc(UtcTime(std::chrono::days(20'000)) + 1h);
    EXPECT_EQ(take(text), "");
    clock.advance(std::chrono::hours(13));
    clock.setUtc(UtcTime(std::chrono::days(20'000)) + 14h);
    text.time = 14h;
    EXPECT_EQ(take(text), "");
    EXPECT_TRUE(feed.isFresh(clock.now()));
}

// REQ-POSITION-13: A report is refused if it has another call sign, if its time is more than 60 s from the clock of
// this computer, or if it cannot be read. Midnight between the two times does no harm.
TEST_F(PositionFeedTest, IsNotBelievedWithoutAReason)
{
    PositionText late = north(0.0);
    clock.setUtc(UtcTime(std::chrono::days(20'000)) + 10s);
    late.time = 23h + 59min + 30s;
    EXPECT_EQ(take(late), "");
    late.time = 23h + 59min + 9s;
    EXPECT_EQ(take(late), "its time and the clock of this computer differ by 61 s");
    late.time = 1min + 11s;
    EXPECT_EQ(take(late), "its time and the clock of this computer differ by 61 s");
    EXPECT_EQ(take(readPosition("0,0,0")), "latitude and longitude are 0, as without a GPS fix");
    EXPECT_EQ(feed.lastRefusal(), QStringLiteral("latitude and longitude are 0, as without a GPS fix"));
    feed.setLimits({.name = QStringLiteral("v2850795")});
    EXPECT_FALSE(feed.last()) << "what was known of another one";
    PositionText named = north(0.0);
    EXPECT_EQ(take(named), "the report is from another call sign than v2850795");
    EXPECT_EQ(feed.take(named, clock.now(), clock.utc()).error().code, ErrorCode::NotAvailable);
    named.name = QStringLiteral("V2850795");
    EXPECT_EQ(take(named), "");
}

// REQ-POSITION-14: A position without a new report for the time in the profile does not count any more.
TEST_F(PositionFeedTest, GetsStale)
{
    EXPECT_EQ(textOf(feed.isFresh(clock.now()).error()), "no position was received");
    EXPECT_FALSE(feed.age(clock.now()));
    EXPECT_EQ(take(north(0.0)), "");
    clock.advance(Seconds(30.0));
    EXPECT_TRUE(feed.isFresh(clock.now()));
    EXPECT_EQ(feed.age(clock.now()), Seconds(30.0));
    clock.advance(Seconds(0.01));
    EXPECT_EQ(textOf(feed.isFresh(clock.now()).error()), "no position was received for 30 s");
}

}  // namespace
}  // namespace boresight::position
