// SPDX-License-Identifier: GPL-3.0-or-later
// Whole passes, and the wrap on which each of them has to begin.
#include "tests/core/plan/plan_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace boresight::plan {
namespace {

// So fast that only the cable decides.
constexpr AxisSpeeds kFast{1000.0, 10000.0};

PlanMount mountOf(const Row& row)
{
    return mountWith(kFast, kFast, {degrees(row, "az_lo"), degrees(row, "az_hi")},
                     {0_deg, row.at("flip") == "1" ? 180_deg : 90_deg});
}

// The azimuths that the path passes one after the other: its start, both extremes, its end.
std::vector<double> cornersOf(const Row& row)
{
    const double low = number(row, "path_min");
    const double high = number(row, "path_max");
    if (row.at("choice") == "none") {
        return {low, high};
    }
    const double side = row.at("choice") == "flip" ? 180.0 : 0.0;
    const double rotor = number(row, "start_az") - side;
    const double start = std::clamp(rotor + 360.0 * std::round((0.5 * (low + high) - rotor) / 360.0), low, high);
    const double end = start + number(row, "end_az") - number(row, "start_az");
    return end - low < high - end ? std::vector{start, high, low, end} : std::vector{start, low, high, end};
}

// A path of this kind at a low elevation.
DirectionAt pathThrough(const std::vector<double>& corners, UtcTime from, UtcTime to)
{
    return [=](UtcTime at) -> std::optional<SkyPointing> {
        const double way = Seconds(at - from) / Seconds(to - from) * static_cast<double>(corners.size() - 1);
        const auto leg = std::min(static_cast<std::size_t>(way), corners.size() - 2);
        const double azimuth = std::lerp(corners[leg], corners[leg + 1], way - static_cast<double>(leg));
        return SkyPointing{Angle::fromDegrees(azimuth).wrapped360(), 20_deg};
    };
}

void expectMeets(const PassPlan& plan, const Row& row, double tolerance)
{
    ASSERT_FALSE(plan.variants.empty());
    const auto direct =
        std::ranges::count_if(plan.variants, [](const PlanVariant& one) { return one.way == PlanWay::Direct; });
    EXPECT_EQ(direct, static_cast<int>(number(row, "n_feasible_direct")));
    const PlanVariant& best = plan.best();
    const std::string choice = row.at("choice");
    if (choice == "none") {
        EXPECT_FALSE(best.isWhole()) << keyOf(best.way).toStdString();
        return;
    }
    EXPECT_EQ(best.way, choice == "flip" ? PlanWay::OverTheTop : PlanWay::Direct) << keyOf(best.way).toStdString();
    EXPECT_NEAR(best.start().azimuth.degrees(), number(row, "start_az"), tolerance);
    EXPECT_NEAR(best.end().azimuth.degrees(), number(row, "end_az"), tolerance);
}

PlanTask taskOf(const Row& row)
{
    return {.from = utc(row, "aos_utc"), .to = utc(row, "los_utc"), .now = {degrees(row, "az_now"), 0_deg}};
}

}  // namespace

// REQ-PLAN-02: For a whole pass the plan takes the wrap on which the cable has room for all of it, direct rather than
// over the top, and of several the one whose start is nearest. If no wrap has room, the plan reports that.
TEST(WrapCases, TheSweptAzimuthsDecide)
{
    const auto rows = tableRows("WRAP_CASES", "wrap_cases.csv");
    ASSERT_FALSE(rows.empty());
    for (const Row& row : rows) {
        SCOPED_TRACE(row.at("name") + " " + row.at("site") + " " + row.at("aos_utc"));
        const PlanTask task = taskOf(row);
        const DirectionAt directionAt = pathThrough(cornersOf(row), task.from, task.to);
        expectMeets(planPass(directionAt, task, mountOf(row)), row, 0.01);
    }
}

// REQ-PLAN-02
TEST(WrapCases, TheElementsGiveTheSame)
{
    if (!hasTable("TLE_SATS", "tle_sats.txt")) {
        GTEST_SKIP() << "no " << tablePath("TLE_SATS", "tle_sats.txt");
    }
    const std::map<std::string, Site> sites{{"Lisbon", {38.757_deg, -9.117_deg, 80.0}},
                                            {"Sydney", {-33.87_deg, 151.21_deg, 10.0}},
                                            {"Svalbard", {78.23_deg, 15.39_deg, 450.0}}};
    const auto sets = elementsByName();
    for (const Row& row : tableRows("WRAP_CASES", "wrap_cases.csv")) {
        SCOPED_TRACE(row.at("name") + " " + row.at("site") + " " + row.at("aos_utc"));
        ASSERT_TRUE(sets.contains(row.at("name")) && sites.contains(row.at("site")));
        const DirectionAt directionAt = directionsOf(sets.at(row.at("name")), sites.at(row.at("site")));
        expectMeets(planPass(directionAt, taskOf(row), mountOf(row)), row, 0.05);
    }
}

}  // namespace boresight::plan
