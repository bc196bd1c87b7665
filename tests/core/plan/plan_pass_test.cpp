// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/plan_pass.h"

#include "tests/core/plan/plan_tables.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace boresight::plan {
namespace {

using namespace std::chrono_literals;
using testing::Each;
using testing::IsEmpty;

const UtcTime kRise = std::chrono::sys_days(std::chrono::year(2026) / 12 / 24);
constexpr AxisSpeeds kSpeeds{10.0, 10.0};

// One degree a second at one elevation, from one azimuth to another.
struct Arc
{
    double from;
    double to;
    Angle elevation = 30_deg;

    [[nodiscard]] UtcTime sets() const { return kRise + std::chrono::seconds(std::lround(std::abs(to - from))); }
    [[nodiscard]] DirectionAt directions() const
    {
        return [arc = *this](UtcTime at) -> std::optional<SkyPointing> {
            const double way = Seconds(at - kRise).count() * (arc.to > arc.from ? 1.0 : -1.0);
            return SkyPointing{Angle::fromDegrees(arc.from + way).wrapped360(), arc.elevation};
        };
    }
};

PassPlan planOf(const Arc& arc, const PlanMount& mount, AxisPosition now = {})
{
    return planPass(arc.directions(), {.from = kRise, .to = arc.sets(), .now = now, .bound = {}}, mount);
}

PlanMount mountOf(const TravelRange& azimuths, const TravelRange& elevations = {0_deg, 90_deg},
                  const pointing::Region& region = {})
{
    return mountWith(kSpeeds, kSpeeds, azimuths, elevations, region);
}

const PlanVariant* variantOn(const PassPlan& plan, PlanWay way)
{
    const auto found = std::ranges::find(plan.variants, way, &PlanVariant::way);
    return found != plan.variants.end() ? &*found : nullptr;
}

bool isPermitted(const PlanVariant& variant, const PlanMount& mount)
{
    return std::ranges::all_of(variant.moments,
                               [&](const PlannedMoment& moment) { return mount.region.permits(moment.axes); });
}

}  // namespace

// REQ-PLAN-04: A pass that begins near the end of the cable and goes towards this end begins one turn farther back. So
// the cable does not end during the pass, where the nearest wrap would lose half a minute.
TEST(PlanPass, BeginsWhereTheCableDoesNotEnd)
{
    const PassPlan west = planOf({18.0, -160.0}, mountOf({-90_deg, 450_deg}), {10_deg, 0_deg});
    EXPECT_NEAR(west.best().start().azimuth.degrees(), 378.0, 1e-6);
    EXPECT_NEAR(west.best().end().azimuth.degrees(), 200.0, 1e-6);
    EXPECT_LT(west.best().forecast.peak, 0.01_deg);
    EXPECT_NEAR(west.best().margin.degrees(), 72.0, 1e-6);
    const PassPlan low = planOf({321.0, 200.0}, mountOf({-90_deg, 450_deg}), {-40_deg, 0_deg});
    EXPECT_NEAR(low.best().start().azimuth.degrees(), 321.0, 1e-6);
    EXPECT_NEAR(low.best().toStart.count(), 361.0 / 10.0 + 1.0, 0.01) << "a whole turn from its place";
}

TEST(PlanPass, OfTwoWrapsTakesTheNearerOne)
{
    const Arc arc{20.0, 60.0};
    EXPECT_NEAR(planOf(arc, mountOf({-90_deg, 450_deg}), {400_deg, 0_deg}).best().start().azimuth.degrees(), 380.0,
                1e-6);
    EXPECT_NEAR(planOf(arc, mountOf({-90_deg, 450_deg}), {100_deg, 0_deg}).best().start().azimuth.degrees(), 20.0,
                1e-6);
    EXPECT_EQ(planOf(arc, mountOf({-90_deg, 450_deg})).variants.size(), 2U);
}

TEST(PlanPass, DirectComesBeforeOverTheTop)
{
    const PlanMount mount = mountOf({-90_deg, 450_deg}, {0_deg, 180_deg});
    const PassPlan plan = planOf({20.0, 60.0}, mount, {200_deg, 150_deg});
    EXPECT_EQ(plan.best().way, PlanWay::Direct) << "although the other start is nearer";
    ASSERT_TRUE(variantOn(plan, PlanWay::OverTheTop));
    const PassPlan flipped = planOf({340.0, 460.0}, mountOf({0_deg, 360_deg}, {0_deg, 180_deg}));
    EXPECT_EQ(flipped.best().way, PlanWay::OverTheTop);
    EXPECT_NEAR(flipped.best().start().azimuth.degrees(), 160.0, 1e-6);
    EXPECT_NEAR(flipped.best().start().elevation.degrees(), 150.0, 1e-6);
    EXPECT_LT(flipped.best().forecast.peak, 0.01_deg);
}

// REQ-PLAN-05: If no wrap has room for a pass, the plan unwraps where the least time is lost, and there where the
// target is lowest. It reports the time of the unwrap and the time lost.
TEST(PlanPass, SplitsWhereTheLossIsLeast)
{
    // From 340° through north to 100° and on, rising: 20 s on the first wrap, 200 s on the second one.
    const Arc arc{340.0, 560.0};
    const PlanMount mount = mountOf({0_deg, 360_deg});
    const PassPlan plan = planOf(arc, mount, {340_deg, 0_deg});
    const PlanVariant& best = plan.best();
    EXPECT_FALSE(best.isWhole());
    // Waiting at the beginning of the second wrap loses the first 20 s. An unwrap takes 37 s.
    EXPECT_EQ(best.way, PlanWay::WaitsAtTheEnd);
    EXPECT_NEAR(best.forecast.beyond.count(), 20.0, 1.0);
    EXPECT_NEAR(best.start().azimuth.degrees(), 0.0, 1e-6);

    const PassPlan long_ = planOf({260.0, 560.0}, mount, {340_deg, 0_deg});
    EXPECT_EQ(long_.best().way, PlanWay::Unwraps);
    ASSERT_TRUE(long_.best().unwrap);
    EXPECT_NEAR(long_.best().forecast.beyond.count(), 33.0, 2.0) << "the target comes towards the mount";
    EXPECT_TRUE(isPermitted(long_.best(), mount));
    EXPECT_LE(long_.best().unwrap->from, kRise + 100s);
}

TEST(PlanPass, UnwrapsWhereTheTargetIsLow)
{
    const auto directionAt = [](UtcTime at) -> std::optional<SkyPointing> {
        const double seconds = Seconds(at - kRise).count();
        return SkyPointing{Angle::fromDegrees(200.0 + seconds).wrapped360(), Angle::fromDegrees(5.0 + seconds / 10.0)};
    };
    const PassPlan plan = planPass(directionAt, {.from = kRise, .to = kRise + 420s}, mountOf({0_deg, 500_deg}));
    const PlanVariant* const unwraps = variantOn(plan, PlanWay::Unwraps);
    ASSERT_TRUE(unwraps);
    ASSERT_EQ(plan.best().way, PlanWay::Unwraps);
    EXPECT_LT(plan.best().unwrap->from, kRise + 165s) << "early, while the target is low";
    EXPECT_GE(plan.best().unwrap->to, kRise + 160s) << "but not before the other wrap has room";
}

// REQ-PLAN-06: The plan keeps to the permitted places. Where horizon or keep-outs hide the target, the error does not
// count, and the time is reported. The axes go around a keep-out.
TEST(PlanPass, KeepsOutOfWhatIsForbidden)
{
    pointing::Region region;
    region.keepOuts.push_back(
        {.name = "mast", .azimuthFrom = 90_deg, .azimuthTo = 120_deg, .elevationMin = 0_deg, .elevationMax = 60_deg});
    const PlanMount mount = mountOf({-90_deg, 450_deg}, {0_deg, 90_deg}, region);
    const PassPlan plan = planOf({20.0, 200.0}, mount);
    const PlanVariant& best = plan.best();
    EXPECT_NEAR(best.forecast.hidden.count(), 30.0, 1.0);
    EXPECT_LT(best.forecast.beyond, 4s) << "the way around the mast takes a moment at its end";
    EXPECT_TRUE(isPermitted(best, mount));
}

TEST(PlanPass, WhatTheHorizonHidesNeedsNoRoomOfTheCable)
{
    pointing::Region region;
    region.horizon = {{0_deg, 50_deg}, {1_deg, 0_deg}, {340_deg, 0_deg}, {341_deg, 50_deg}};
    const PassPlan plan = planOf({342.0, 460.0}, mountOf({0_deg, 360_deg}, {0_deg, 90_deg}, region));
    ASSERT_FALSE(plan.variants.empty());
    EXPECT_TRUE(plan.best().isWhole());
    EXPECT_NEAR(plan.best().start().azimuth.degrees(), 0.0, 1.0) << "it waits where the target comes out";
    EXPECT_GT(plan.best().forecast.hidden, 15s);
}

// REQ-PLAN-07: The forecast has peak and rms of the error, the time above a bound, and the loss for the beam width. The
// part that is hidden does not count.
TEST(Forecast, CountsWhatIsSeen)
{
    std::vector<PlannedMoment> moments;
    for (int i = 0; i <= 10; ++i) {
        moments.push_back({.utc = kRise + std::chrono::seconds(i),
                           .error = i >= 4 && i <= 6 ? 3_deg
                                    : i == 9         ? 50_deg
                                                     : 1_deg,
                           .isHidden = i >= 8});
    }
    const Forecast forecast = forecastOf(moments, 2_deg, 10_deg);
    EXPECT_EQ(forecast.peak, 3_deg);
    EXPECT_NEAR(forecast.beyond.count(), 3.0, 1e-9);
    EXPECT_NEAR(forecast.hidden.count(), 2.5, 1e-9);
    EXPECT_NEAR(forecast.rms.degrees(), std::sqrt((4.5 * 1.0 + 3.0 * 9.0) / 7.5), 1e-9);
    EXPECT_NEAR(forecast.peakLoss.value(), 12.0 * 0.09, 1e-9);
    EXPECT_FALSE(forecastOf(moments, 2_deg, 1_deg).peakLoss) << "beyond the main lobe";
}

TEST(PlanPass, WithoutAnOrbitThereIsNoPlan)
{
    const auto nothing = [](UtcTime) { return std::optional<SkyPointing>(); };
    EXPECT_THAT(planPass(nothing, {.from = kRise, .to = kRise + 60s}, mountOf({0_deg, 360_deg})).variants, IsEmpty());
}

TEST(PlanPass, NeedsTwoAxes)
{
    profile::Profile profile;
    EXPECT_TRUE(planMount(profile, profile.antenna({})));
    profile.azimuth.driver = profile::AxisDriver::None;
    EXPECT_FALSE(planMount(profile, profile.antenna({})));
}

TEST(PlanPass, AnXYMountNeedsNone)
{
    profile::Profile profile;
    profile.pointing.geometry.kind = pointing::Geometry::XY;
    EXPECT_FALSE(planMount(profile, profile.antenna({})));
}

// REQ-PLAN-08: Variants are compared side by side: a pass near the zenith costs a slow mount degrees, and over the top
// only the distance from the zenith.
TEST(PlanPass, ComparesTheWaysThroughTheKeyhole)
{
    // A straight line through space that passes 0.2° beside the zenith at 1 °/s.
    const auto directionAt = [](UtcTime at) -> std::optional<SkyPointing> {
        const Angle along = Angle::fromDegrees(Seconds(at - kRise).count() - 80.0);
        const double east = std::sin(along.radians());
        const double up = std::cos(along.radians()) * std::cos((0.2_deg).radians());
        const double north = std::cos(along.radians()) * std::sin((0.2_deg).radians());
        return SkyPointing{Angle::fromRadians(std::atan2(east, north)).wrapped360(), Angle::fromRadians(std::asin(up))};
    };
    const PlanTask task{.from = kRise, .to = kRise + 160s, .now = {}, .bound = 1_deg};
    const AxisSpeeds slow{6.0, 12.0};
    const PassPlan plan = planPass(directionAt, task, mountWith(slow, slow, {-90_deg, 450_deg}, {0_deg, 180_deg}));
    EXPECT_EQ(plan.best().way, PlanWay::ThroughTheZenith);
    EXPECT_NEAR(plan.best().forecast.peak.degrees(), 0.2, 0.05);
    const PlanVariant* const direct = variantOn(plan, PlanWay::Direct);
    ASSERT_TRUE(direct && direct->ramp);
    EXPECT_GT(direct->forecast.peak, 4_deg);
    EXPECT_GT(direct->forecast.beyond, 10s);
    EXPECT_LT(direct->ramp->to - direct->ramp->from, 45s);
    const PassPlan upright = planPass(directionAt, task, mountWith(slow, slow, {-90_deg, 450_deg}, {0_deg, 90_deg}));
    EXPECT_EQ(upright.best().way, PlanWay::Direct);
}

}  // namespace boresight::plan
