// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/strip_scale.h"
#include "ui/charts/telemetry_store.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace boresight::ui {
namespace {

std::optional<PeakRange> bruteRange(const std::map<std::int64_t, PeakRange>& bins, std::int64_t first, std::int64_t end)
{
    std::optional<PeakRange> sum;
    for (auto bin = bins.lower_bound(first); bin != bins.end() && bin->first < end; ++bin) {
        if (sum) {
            sum->include(bin->second);
        } else {
            sum = bin->second;
        }
    }
    return sum;
}

// Values with rare single peaks. Some bins are left out, and there are some gaps. The values fill the ring more than
// once.
struct RandomWalk
{
    explicit RandomWalk(unsigned seed) : random(seed) {}

    void step()
    {
        const int dice = std::uniform_int_distribution(0, 999)(random);
        bin += dice < 3 ? std::uniform_int_distribution(7, 4000)(random) : dice < 100 ? dice % 6 : 1;
        const float value = dice == 999 ? 1e4F : std::normal_distribution(0.0F, 1.0F)(random);
        ring.add(bin, value);
        const auto [entry, isNew] = bins.try_emplace(bin, PeakRange{value, value});
        if (!isNew) {
            entry->second.include({value, value});
        }
        bins.erase(bins.begin(), bins.lower_bound(bin - PeakRing::kBins + 1));
    }

    std::mt19937 random;
    PeakRing ring;
    std::map<std::int64_t, PeakRange> bins;
    std::int64_t bin = 123'456;
};

// REQ-UI-17 (PeakRing.*): The charts show every peak of the last half hour at every time scale, and never draw a line
// across a gap.
TEST(PeakRing, AnyRangeHasThePeaksOfBruteForce)
{
    RandomWalk walk(1);
    for (int round = 0; round < 400; ++round) {
        for (int i = 0; i < 600; ++i) {
            walk.step();
        }
        for (int query = 0; query < 10; ++query) {
            std::uniform_int_distribution<std::int64_t> length(0, query < 5 ? 200 : PeakRing::kBins + 9000);
            const std::int64_t end = walk.bin + 50 - length(walk.random);
            const std::int64_t first = end - length(walk.random);
            ASSERT_EQ(walk.ring.range(first, end), bruteRange(walk.bins, first, end)) << first << " to " << end;
        }
    }
    EXPECT_GT(walk.bin, 123'456 + 2 * PeakRing::kBins);
}

// Every column is compared with a simple computation: nothing is missing or doubled, and columns are joined exactly
// where there is no gap.
TEST(PeakRing, ColumnsHoldEveryPeakAndNeverJoinAcrossAGap)
{
    RandomWalk walk(2);
    const PeakGrid grids[] = {{500, 400}, {500, 1100}, {3000, 437}, {15'000, 700}, {90'000, 400}, {90'000, 1999}};
    for (int round = 0; round < 30; ++round) {
        for (int i = 0; i < 5000; ++i) {
            walk.step();
        }
        for (const PeakGrid& grid : grids) {
            const std::int64_t end = grid.columnOf(walk.bin) + 1;
            const std::vector<PeakColumn> columns = walk.ring.columns(grid, end - grid.columns, end);
            std::map<std::int64_t, PeakRange> found;
            std::map<std::int64_t, int> breaks;
            for (std::size_t i = 0; i < columns.size(); ++i) {
                const auto [entry, isNew] = found.try_emplace(columns[i].column, columns[i].range);
                if (!isNew) {
                    EXPECT_FALSE(columns[i].joined);
                    entry->second.include(columns[i].range);
                }
                breaks[columns[i].column] += columns[i].joined ? 0 : 1;
                ASSERT_TRUE(i == 0 || columns[i].column >= columns[i - 1].column);
            }
            std::map<std::int64_t, PeakRange> wanted;
            std::map<std::int64_t, int> wantedBreaks;
            std::optional<std::int64_t> before;
            for (const auto& [bin, range] : walk.bins) {
                if (bin < grid.firstBin(end - grid.columns)) {
                    continue;
                }
                const std::int64_t column = grid.columnOf(bin);
                wanted.try_emplace(column, range).first->second.include(range);
                wantedBreaks[column] += !before || bin - *before > PeakRing::kJoin + 1 ? 1 : 0;
                before = bin;
            }
            ASSERT_EQ(found, wanted);
            ASSERT_EQ(breaks, wantedBreaks);
        }
    }
}

TEST(PeakRing, AColumnHasTheSameBinsWhateverPartIsShown)
{
    const PeakGrid grid{90'000, 417};
    for (std::int64_t bin = 1'000'000; bin < 1'010'000; bin += 7) {
        const std::int64_t column = grid.columnOf(bin);
        EXPECT_LE(grid.firstBin(column), bin);
        EXPECT_GT(grid.firstBin(column + 1), bin);
    }
}

TEST(PeakRing, NothingIsShownOfARoundAgo)
{
    PeakRing ring;
    ring.add(1000, 77.0F);
    ring.add(1000 + PeakRing::kBins, 1.0F);
    EXPECT_EQ(ring.range(0, 2000), std::nullopt);
    EXPECT_EQ(ring.range(0, 10 * PeakRing::kBins), (PeakRange{1.0F, 1.0F}));
}

constexpr SteadyTime kBegin{std::chrono::hours(3)};

TickSample sampleAt(SteadyTime time, Angle commanded, Angle actual)
{
    TickSample sample{.time = time};
    sample.axes[0] = {.commanded = commanded, .actual = actual, .torque = 1.5};
    return sample;
}

// REQ-UI-17 (TelemetryStore.*)
TEST(TelemetryStore, MemoryIsBoundedAndHoldsHalfAnHour)
{
    EXPECT_LT(TelemetryStore::bytes(), 25'000'000U);
    EXPECT_GE(TelemetryStore::kBin * PeakRing::kBins, std::chrono::minutes(30) + std::chrono::seconds(60));
}

// The error belongs to one tick: it does not follow from the extremes of commanded and actual.
TEST(TelemetryStore, TheErrorIsKeptForItselfAndOneTicksPeakSurvivesHalfAnHour)
{
    TelemetryStore store;
    for (int tick = 0; tick < 80'000; ++tick) {
        const Angle place = Angle::fromDegrees(tick % 3600 * 0.1);
        const Angle error = tick == 40'000 ? 0.7_deg : 0.01_deg;
        store.add({sampleAt(kBegin + tick * TelemetryStore::kBin, place, place - error)});
    }
    const PeakRing& error = store.ring(Axis::Azimuth, Channel::Error);
    const auto range = error.range(TelemetryStore::binOf(kBegin), TelemetryStore::binOf(kBegin) + 80'000);
    ASSERT_TRUE(range);
    EXPECT_NEAR(range->max, 0.7, 1e-4);
    EXPECT_NEAR(range->min, 0.01, 1e-4);
    EXPECT_FALSE(store.ring(Axis::Elevation, Channel::Error).range(0, 1'000'000));
}

// Ticks that are up to 8 ms early or late give one value for each bin, in order.
TEST(TelemetryStore, UnsteadyTicksLeaveNoHoles)
{
    TelemetryStore store;
    std::mt19937 random(5);
    std::uniform_int_distribution late(-8, 8);
    for (int tick = 0; tick < 5000; ++tick) {
        const auto time = kBegin + tick * TelemetryStore::kBin + std::chrono::milliseconds(10 + late(random));
        store.add({sampleAt(time, Angle::fromDegrees(tick), Angle::fromDegrees(tick))});
    }
    const std::int64_t first = TelemetryStore::binOf(kBegin);
    int offBins = 0;
    for (int tick = 100; tick < 4900; ++tick) {
        const auto range = store.ring(Axis::Azimuth, Channel::Actual).range(first + tick, first + tick + 1);
        ASSERT_TRUE(range) << tick;
        EXPECT_NEAR(range->min, tick, 1.0);
        offBins += range->min != range->max ? 1 : 0;
    }
    EXPECT_EQ(offBins, 0);
}

TEST(TelemetryStore, AbsentAndAbsurdValuesAreNoData)
{
    TelemetryStore store;
    TickSample sample{.time = kBegin};
    sample.axes[0].actual = 3_deg;
    sample.axes[0].torque = std::nan("");
    store.add({sample});
    const std::int64_t bin = TelemetryStore::binOf(kBegin);
    EXPECT_TRUE(store.ring(Axis::Azimuth, Channel::Actual).at(bin));
    EXPECT_FALSE(store.ring(Axis::Azimuth, Channel::Error).at(bin));
    EXPECT_FALSE(store.ring(Axis::Azimuth, Channel::Torque).at(bin));
    EXPECT_TRUE(store.ring(Axis::Azimuth, Channel::Actual).at(bin + PeakRing::kJoin));
    EXPECT_FALSE(store.ring(Axis::Azimuth, Channel::Actual).at(bin + PeakRing::kJoin + 1));
}

TEST(StripScale, HoldsAllOnRoundNumbersAndKeepsAMeaningfulSpan)
{
    StripScale scale(0.2);
    scale.fit(10.001, 10.002);
    EXPECT_GE(scale.upper() - scale.lower(), 0.2);
    EXPECT_LE(scale.upper() - scale.lower(), 0.4);
    EXPECT_LE(scale.lower(), 10.001);
    EXPECT_GE(scale.upper(), 10.002);
    scale.fit(-90.0, 450.0);
    EXPECT_LE(scale.lower(), -90.0);
    EXPECT_GE(scale.upper(), 450.0);
    EXPECT_DOUBLE_EQ(scale.step(), 200.0);
    EXPECT_EQ(scale.decimals(), 0);
}

TEST(StripScale, GrowsAtOnceAndShrinksOnlyWhenMuchIsFree)
{
    StripScale scale(0.1, ScaleForm::AroundZero);
    scale.fit(-0.2, 4.0);
    const double upper = scale.upper();
    EXPECT_GE(upper, 4.0);
    EXPECT_DOUBLE_EQ(scale.lower(), -upper);
    scale.fit(-0.2, 2.5);
    EXPECT_DOUBLE_EQ(scale.upper(), upper);
    scale.fit(-0.2, 0.3);
    EXPECT_LT(scale.upper(), 0.6);
}

}  // namespace
}  // namespace boresight::ui
