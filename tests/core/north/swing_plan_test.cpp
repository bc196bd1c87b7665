// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/swing_plan.h"

#include "core/profile/profile.h"

#include <gtest/gtest.h>

#include <limits>

namespace boresight {
namespace {

using namespace boresight::literals;

const tracking::MotionLimits kLimits = profile::referenceAzimuth().limits;
const TravelRange kElevations{.min = 0_deg, .max = 90_deg};

pointing::PermittedRegion regionOf(Angle from, Angle to, const pointing::Region& drawn = {})
{
    return {drawn, {.min = from, .max = to}, kElevations};
}

SwingPlan planAt(const pointing::PermittedRegion& region, Angle azimuth, Angle elevation, int headings = 0)
{
    return planSwing({.rate = 3_deg_s, .headings = headings}, {.azimuth = azimuth, .elevation = elevation}, region,
                     kLimits);
}

TEST(SwingPlan, TurnsOnceAroundWhereTheMountStands)
{
    const SwingPlan plan = planAt(regionOf(-270_deg, 450_deg), 100_deg, 30_deg);
    EXPECT_TRUE(plan.obstacle.isEmpty());
    EXPECT_NEAR(-80.0, plan.azimuth.min.degrees(), 1e-9);
    EXPECT_NEAR(280.0, plan.azimuth.max.degrees(), 1e-9);
    EXPECT_EQ(30_deg, plan.elevation);
    EXPECT_GT(plan.duration, Seconds(240.0));
    EXPECT_LT(plan.duration, Seconds(400.0));
    EXPECT_FALSE(plan.text.isEmpty());
}

// Story: at 10.00° elevation the swing ran without advice. Its curve was of little use, and the tilt was not measured.
TEST(SwingPlan, AdvisesTheElevationThatIsBest)
{
    const auto textAt = [](Angle elevation) {
        return planAt(regionOf(-270_deg, 450_deg), 100_deg, elevation).text.toStdString();
    };
    EXPECT_NE(std::string::npos, textAt(10_deg).find("raise the boom to 30° first")) << textAt(10_deg);
    EXPECT_NE(std::string::npos, textAt(9.4_deg).find("no tilt at this elevation (it is measured between 10° and 75°"));
    for (const Angle well : {20_deg, 30_deg, 60_deg}) {
        EXPECT_EQ(std::string::npos, textAt(well).find(';')) << textAt(well);
    }
}

TEST(SwingPlan, StaysOffWhatIsForbiddenAtItsElevation)
{
    pointing::Region drawn;
    drawn.keepOuts.push_back(
        {.name = "mast", .azimuthFrom = 300_deg, .azimuthTo = 320_deg, .elevationMin = 0_deg, .elevationMax = 40_deg});
    const auto region = regionOf(0_deg, 400_deg, drawn);
    const SwingPlan below = planAt(region, 100_deg, 30_deg);
    EXPECT_TRUE(below.obstacle.isEmpty());
    EXPECT_LT(below.azimuth.max, 300_deg);
    EXPECT_GT(planAt(region, 100_deg, 50_deg).azimuth.max, 350_deg);
    EXPECT_FALSE(planAt(region, 310_deg, 30_deg).obstacle.isEmpty());  // the mount stands in it
}

TEST(SwingPlan, RefusesWhatWouldTellNothing)
{
    EXPECT_FALSE(planAt(regionOf(0_deg, 180_deg), 100_deg, 30_deg).obstacle.isEmpty());
    EXPECT_FALSE(planAt(regionOf(0_deg, 400_deg), 100_deg, 30_deg, 4).obstacle.isEmpty());
    EXPECT_FALSE(
        planSwing({.rate = 0.1_deg_s}, {.azimuth = 100_deg, .elevation = 30_deg}, regionOf(0_deg, 400_deg), kLimits)
            .obstacle.isEmpty());
    const AngularRate none = AngularRate::fromDegrees(std::numeric_limits<double>::quiet_NaN());
    EXPECT_FALSE(planSwing({.rate = none}, {.azimuth = 100_deg, .elevation = 30_deg}, regionOf(0_deg, 400_deg), kLimits)
                     .obstacle.isEmpty());
    EXPECT_TRUE(planAt(regionOf(0_deg, 400_deg), 100_deg, 75_deg).obstacle.isEmpty());
    EXPECT_FALSE(planAt(regionOf(0_deg, 400_deg), 100_deg, 76_deg).obstacle.isEmpty());
}

TEST(SwingPlan, StopsOnceAtEachHeadingEachWay)
{
    const SwingPlan circle = planAt(regionOf(-270_deg, 450_deg), 100_deg, 30_deg, 8);
    const auto stops = stopsOf(circle);
    ASSERT_EQ(16U, stops.size());
    EXPECT_NEAR(45.0, (stops[1] - stops[0]).degrees(), 1e-9);  // the ninth stop would be the first again
    EXPECT_EQ(stops[7], stops[8]);
    EXPECT_EQ(stops.front(), stops.back());
    const SwingPlan arc = planAt(regionOf(0_deg, 282_deg), 100_deg, 30_deg, 8);
    EXPECT_NEAR(40.0, (stopsOf(arc)[1] - stopsOf(arc)[0]).degrees(), 1e-9);
}

}  // namespace
}  // namespace boresight
