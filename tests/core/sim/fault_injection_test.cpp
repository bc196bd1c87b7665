// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/fault_injection.h"

#include <gtest/gtest.h>

namespace boresight::sim {
namespace {

// REQ-SIM-10 (FaultSchedule.*)
TEST(FaultSchedule, ActiveFromStartToEnd)
{
    FaultSchedule schedule;
    schedule.add({.kind = FaultKind::Silence, .axis = Axis::Azimuth, .at = Seconds(5.0), .duration = Seconds(3.0)});
    EXPECT_FALSE(schedule.isActive(FaultKind::Silence, Axis::Azimuth, Seconds(4.999)));
    EXPECT_TRUE(schedule.isActive(FaultKind::Silence, Axis::Azimuth, Seconds(5.0)));
    EXPECT_FALSE(schedule.isActive(FaultKind::Silence, Axis::Elevation, Seconds(6.0)));
    EXPECT_FALSE(schedule.isActive(FaultKind::Stall, Axis::Azimuth, Seconds(6.0)));
    EXPECT_FALSE(schedule.isActive(FaultKind::Silence, Axis::Azimuth, Seconds(8.0)));
}

TEST(FaultSchedule, LatestWinsAndRemovingRestores)
{
    FaultSchedule schedule;
    schedule.add({.kind = FaultKind::Wind, .value = 10.0});
    const auto second = schedule.add({.kind = FaultKind::Wind, .value = 20.0});
    EXPECT_EQ(schedule.active(FaultKind::Wind, Axis::Elevation, Seconds(1.0)), 20.0);
    schedule.remove(second);
    EXPECT_EQ(schedule.active(FaultKind::Wind, Axis::Elevation, Seconds(1.0)), 10.0);
    schedule.clear();
    EXPECT_FALSE(schedule.active(FaultKind::Wind, Axis::Elevation, Seconds(1.0)));
}

}  // namespace
}  // namespace boresight::sim
