// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wind/wind_watch.h"

#include <gtest/gtest.h>

#include <optional>

namespace boresight::wind {
namespace {

using Cause = WindWatch::Cause;

class WindWatchTest : public ::testing::Test
{
protected:
    // One reading each second; no reading if `speed` is empty.
    void blow(std::optional<double> speed, Seconds time)
    {
        constexpr Seconds kStep{0.1};
        for (int i = 0; i < static_cast<int>(time / kStep + 0.5); ++i) {
            if (speed && i % 10 == 0) {
                watch.take(*speed, now);
            }
            watch.step(limits, now);
            now += std::chrono::duration_cast<SteadyTime::duration>(kStep);
        }
    }

    SteadyTime now{std::chrono::seconds(1000)};
    Limits limits{.calm = Seconds(60.0)};
    WindWatch watch{now};
};

// REQ-WIND-05: The wind is too strong when the mean over the gust time is above the upper limit. A single high reading
// among several lower ones is no gust.
TEST_F(WindWatchTest, AGustIsAMean)
{
    blow(12.0, Seconds(10.0));
    EXPECT_EQ(watch.cause(), Cause::None);
    blow(20.0, Seconds(1.0));  // (12 + 12 + 20) / 3
    EXPECT_EQ(watch.cause(), Cause::None);
    blow(12.0, Seconds(5.0));
    EXPECT_EQ(watch.cause(), Cause::None);
    blow(20.0, Seconds(2.0));  // (12 + 20 + 20) / 3
    EXPECT_EQ(watch.cause(), Cause::Wind);
    EXPECT_NEAR(watch.peak(), 52.0 / 3.0, 1e-9);
}

TEST_F(WindWatchTest, WithoutAMeanEachReadingCounts)
{
    limits.gust = Seconds(0.0);
    blow(12.0, Seconds(3.0));
    blow(15.1, Seconds(0.1));
    EXPECT_EQ(watch.cause(), Cause::Wind);
}

// An anemometer with one reading every 20 s.
TEST_F(WindWatchTest, ARareReadingCountsUntilTheNext)
{
    watch.take(16.0, now);
    blow(std::nullopt, Seconds(20.0));
    EXPECT_EQ(watch.cause(), Cause::Wind);
    EXPECT_EQ(watch.last(), 16.0);
    EXPECT_FALSE(watch.isSilent());
}

// REQ-WIND-06: A strong wind ends only when the mean was below the lower limit for the calm time without interruption.
TEST_F(WindWatchTest, CalmMustLast)
{
    blow(17.0, Seconds(3.0));
    blow(12.0, Seconds(600.0));
    EXPECT_EQ(watch.cause(), Cause::Wind) << "between the limits";
    blow(8.0, Seconds(50.0));
    blow(11.0, Seconds(5.0));
    blow(8.0, Seconds(55.0));
    EXPECT_EQ(watch.cause(), Cause::Wind) << "a break of the calm";
    blow(8.0, Seconds(8.0));
    EXPECT_EQ(watch.cause(), Cause::None);
    EXPECT_EQ(watch.peak(), 0.0);
}

// REQ-WIND-07: The wind is unknown after the time in the profile without a reading, also if there never was one.
// Silence never ends a strong wind. If the profile says so, silence counts as a strong wind.
TEST_F(WindWatchTest, SilenceIsUnknown)
{
    blow(std::nullopt, Seconds(30.0));
    EXPECT_FALSE(watch.isSilent());
    blow(std::nullopt, Seconds(1.0));
    EXPECT_TRUE(watch.isSilent());
    EXPECT_EQ(watch.cause(), Cause::None);
    blow(17.0, Seconds(2.0));
    EXPECT_FALSE(watch.isSilent());
    blow(8.0, Seconds(30.0));
    blow(std::nullopt, Seconds(600.0));
    EXPECT_TRUE(watch.isSilent());
    EXPECT_EQ(watch.cause(), Cause::Wind);
    blow(8.0, Seconds(55.0));
    EXPECT_EQ(watch.cause(), Cause::Wind) << "the calm begins again after the silence";
    blow(8.0, Seconds(10.0));
    EXPECT_EQ(watch.cause(), Cause::None);
}

// REQ-WIND-07
TEST_F(WindWatchTest, SilenceCountsWhereTheProfileWantsThat)
{
    limits.silenceCounts = true;
    blow(5.0, Seconds(10.0));
    blow(std::nullopt, Seconds(31.0));
    EXPECT_EQ(watch.cause(), Cause::Silence);
    blow(5.0, Seconds(55.0));
    EXPECT_EQ(watch.cause(), Cause::Silence);
    blow(5.0, Seconds(10.0));
    EXPECT_EQ(watch.cause(), Cause::None);
    blow(std::nullopt, Seconds(31.0));
    limits.silenceCounts = false;
    blow(std::nullopt, Seconds(1.0));
    EXPECT_EQ(watch.cause(), Cause::None);
}

TEST_F(WindWatchTest, AFloodOfReadingsIsBounded)
{
    for (int i = 0; i < 100'000; ++i) {
        watch.take(i < 50'000 ? 30.0 : 5.0, now);
    }
    watch.step(limits, now);
    EXPECT_EQ(watch.cause(), Cause::None);
    EXPECT_EQ(watch.last(), 5.0);
}

}  // namespace
}  // namespace boresight::wind
