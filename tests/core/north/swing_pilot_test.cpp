// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/swing_pilot.h"

#include "tests/core/mount/mount_bench.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

// Story: the swing of a slow rotator was planned with the speed of the profile, and ended itself for being late.
TEST(SwingPilot, PlansNoFasterThanTheRotator)
{
    profile::Profile fast;
    fast.azimuth.limits.speed = 4.0 * SimpleBox::kSpeed;
    SimpleBench bench({}, fast);
    const profile::InForce profile{fast};
    const fakes::ManualClock clock;
    const LiveSensor sensor(profile, clock);
    const AxisObserver axes(bench.control(), clock);
    EventLog log(clock);
    SwingPilot pilot(bench.control(), profile, sensor, axes, clock, log);
    bench.run(Seconds(1.0));
    pilot.plan({.rate = calibration::kFastestSwing, .headings = 0});
    const SwingPlan plan = pilot.planned();
    EXPECT_TRUE(plan.obstacle.isEmpty()) << plan.obstacle.toStdString();
    EXPECT_EQ(*bench.can().axes[index(Axis::Azimuth)]->fastest, plan.rate);
}

}  // namespace
}  // namespace boresight
