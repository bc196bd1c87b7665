// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/supervision/watch.h"

#include <QStringList>

#include <gtest/gtest.h>

namespace boresight::supervision {
namespace {

constexpr WatchLimits kLimits{
    .hint = 1.0, .stop = 2.0, .release = 0.5, .after = Seconds(0.5), .quietFor = Seconds(1.0)};

class WatchTest : public ::testing::Test
{
protected:
    // The value stays for this time and is checked every 20 ms.
    void stay(double value, Seconds time)
    {
        for (Seconds passed{0.0}; passed < time; passed += Seconds(0.02)) {
            now += std::chrono::milliseconds(20);
            watch.update(now, value, kLimits, [value] { return QString::number(value); });
        }
    }
    [[nodiscard]] std::string told() const { return watch.observed() ? watch.observed()->what.toStdString() : "-"; }
    [[nodiscard]] bool stops() const { return watch.observed() && watch.observed()->weight == Weight::Stop; }

    Watch watch{Symptom::FollowingError};
    SteadyTime now{std::chrono::hours(1)};
};

// REQ-SUPERVISION-12 (WatchTest.*): No alarm flickers. The text of an alarm keeps its numbers until the alarm becomes a
// stop or the value has doubled.
TEST_F(WatchTest, BeginsAfterItsTimeAndEndsWhenQuiet)
{
    stay(1.1, Seconds(0.48));
    EXPECT_EQ(told(), "-");
    stay(1.2, Seconds(0.06));
    EXPECT_EQ(told(), "1.2");
    EXPECT_FALSE(stops());
    stay(0.4, Seconds(0.98));
    EXPECT_EQ(told(), "1.2");
    stay(0.4, Seconds(0.06));
    EXPECT_EQ(told(), "-");
}

TEST_F(WatchTest, DoesNotFlickerAroundItsLimits)
{
    stay(1.1, Seconds(1.0));
    for (int i = 0; i < 50; ++i) {
        stay(0.6, Seconds(0.5));
        EXPECT_NE(told(), "-") << "above the release";
        stay(0.4, Seconds(0.5));
        EXPECT_NE(told(), "-") << "quiet for too short";
        stay(1.1, Seconds(0.5));
        EXPECT_EQ(told(), "1.1") << "the text does not chatter";
    }
}

TEST_F(WatchTest, SpikesDoNotAddUp)
{
    for (int i = 0; i < 50; ++i) {
        stay(5.0, Seconds(0.4));
        stay(0.9, Seconds(0.02));
    }
    EXPECT_EQ(told(), "-");
}

TEST_F(WatchTest, AHintBecomesAStopAndRemainsOneUntilItIsQuiet)
{
    stay(1.5, Seconds(1.0));
    EXPECT_EQ(told(), "1.5");
    stay(2.1, Seconds(0.48));
    EXPECT_FALSE(stops());
    stay(2.1, Seconds(0.06));
    EXPECT_TRUE(stops());
    EXPECT_EQ(told(), "2.1");
    stay(1.1, Seconds(5.0));
    EXPECT_TRUE(stops());
    stay(0.0, Seconds(1.1));
    EXPECT_EQ(told(), "-");
}

TEST_F(WatchTest, TheTextIsRenewedWhenTheValueHasDoubled)
{
    stay(1.0, Seconds(1.0));
    stay(1.99, Seconds(1.0));
    EXPECT_EQ(told(), "1");
    stay(2.5, Seconds(0.02));
    EXPECT_EQ(told(), "2.5");
    EXPECT_FALSE(stops()) << "not for long enough";
}

}  // namespace
}  // namespace boresight::supervision
