// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tuning/tuning_plan.h"

#include <gmock/gmock.h>

#include <cmath>

namespace boresight {
namespace {

using ::testing::HasSubstr;

const tracking::MotionLimits kLimits{
    .speed = 10_deg_s, .acceleration = 10_deg_s2, .jerk = AngularJerk::fromDegrees(100.0)};

pointing::PermittedRegion region()
{
    pointing::Region limits;
    limits.azimuth = {.min = -90_deg, .max = 450_deg};
    limits.elevation = {.min = 0_deg, .max = 90_deg};
    return pointing::PermittedRegion(limits, limits.azimuth, limits.elevation);
}

TuningWay planned(TuningRun run, Axis axis, Angle azimuth, Angle elevation,
                  const tracking::MotionLimits& limits = kLimits)
{
    return planTuning(run, axis, {.azimuth = azimuth, .elevation = elevation}, region(), limits);
}

// REQ-TUNING-11: Before it moves, a run checks its room. It moves to the side with more room, and is refused with the
// reason if there is none.
TEST(TuningPlan, GoesToTheSideWithMoreRoom)
{
    const TuningWay low = planned(TuningRun::Step, Axis::Elevation, 0_deg, 10_deg);
    EXPECT_TRUE(low.plan.obstacle.isEmpty()) << low.plan.obstacle.toStdString();
    EXPECT_NEAR(low.plan.to.degrees(), 12.0, 1e-9);
    EXPECT_THAT(low.plan.text.toStdString(), HasSubstr("Moves the elevation by 2.00° from axis angle 10.0°"));
    const TuningWay high = planned(TuningRun::Ramp, Axis::Elevation, 0_deg, 89_deg);
    EXPECT_TRUE(high.plan.obstacle.isEmpty());
    EXPECT_NEAR(high.plan.to.degrees(), 87.0, 1e-9);
}

// REQ-TUNING-11
TEST(TuningPlan, IsRefusedWithoutTheRoom)
{
    const TuningWay swing = planned(TuningRun::Sweep, Axis::Elevation, 0_deg, 0.3_deg);
    EXPECT_THAT(swing.plan.obstacle.toStdString(),
                HasSubstr("needs 0.75° of free travel on both sides of the elevation. "
                          "There is only 0.30°"));
    EXPECT_TRUE(planned(TuningRun::Step, Axis::Elevation, 0_deg, 0.3_deg).plan.obstacle.isEmpty());
    EXPECT_THAT(planned(TuningRun::Step, Axis::Azimuth, 0_deg, -5_deg).plan.obstacle.toStdString(),
                HasSubstr("outside the permitted region"));
}

// Story: the question about the backlash run said 0.25°, and the axis moved by 0.20°.
// REQ-TUNING-22: A run states the travel of its set-points, which the limits of motion may reduce.
TEST(TuningPlan, SaysTheWayOfItsSetPoints)
{
    const auto says = [](TuningRun run, const tracking::MotionLimits& limits) {
        return planned(run, Axis::Azimuth, 100_deg, 30_deg, limits).plan.text.toStdString();
    };
    EXPECT_THAT(says(TuningRun::Step, kLimits), HasSubstr("by 2.00° from axis angle 100.0°"));
    EXPECT_THAT(says(TuningRun::Ramp, kLimits), HasSubstr("by 2.00° from axis angle 100.0°"));
    EXPECT_THAT(says(TuningRun::Sweep, kLimits), HasSubstr("±0.27° around axis angle 100.0°"));
    EXPECT_THAT(says(TuningRun::Backlash, kLimits), HasSubstr("±0.20° around axis angle 100.0°"));
    tracking::MotionLimits slow = kLimits;
    slow.speed = 0.3_deg_s;
    EXPECT_THAT(says(TuningRun::Ramp, slow), HasSubstr("by 0.60° from"));
    EXPECT_THAT(says(TuningRun::Sweep, slow), HasSubstr("±0.08° around"));
    EXPECT_NEAR(planned(TuningRun::Ramp, Axis::Elevation, 0_deg, 89_deg, slow).plan.to.degrees(), 88.4, 1e-6);
}

// Story: the question said "from -42.6°" while the card showed an azimuth of 317.4°.
// REQ-TUNING-36: The text of a run names the angle where it begins as an axis angle.
TEST(TuningPlan, NamesItsAxisAngle)
{
    EXPECT_THAT(planned(TuningRun::Step, Axis::Azimuth, Angle::fromDegrees(-42.6), 30_deg).plan.text.toStdString(),
                HasSubstr("Moves the azimuth by 2.00° from axis angle -42.6° and back, in "));
}

// REQ-TUNING-12: The set-points of a run stay within its room and within the limits of motion.
TEST(TuningPlan, RatesStayWithinRoomAndLimits)
{
    for (const TuningRun run : kTuningRuns) {
        const TuningWay found = planned(run, Axis::Azimuth, 100_deg, 30_deg);
        const TuningRoom room = roomFor(run);
        Angle place;
        for (const TuningLeg& leg : found.legs) {
            if (leg.place) {
                EXPECT_LE(abs(*leg.place - 100_deg), room.way);
                continue;
            }
            AngularRate before = leg.rate(Seconds(0.0), place);
            constexpr Seconds kTick{0.02};
            for (Seconds time = kTick; time < leg.time; time += kTick) {
                const AngularRate rate = leg.rate(time, place);
                place += rate * kTick;
                EXPECT_LE(abs(rate), kLimits.speed);
                EXPECT_LE(std::abs((rate - before).degrees()) / 0.02, 10.0);
                EXPECT_LE(abs(place), room.way) << static_cast<int>(run);
                before = rate;
            }
        }
        EXPECT_FALSE(found.legs.empty());
        EXPECT_EQ(found.legs.front().place, std::optional(100_deg));
        EXPECT_EQ(found.legs.back().place, std::optional(100_deg)) << "ends where it began";
    }
}

}  // namespace
}  // namespace boresight
