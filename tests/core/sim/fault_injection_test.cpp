// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/fault_injection.h"

#include <gtest/gtest.h>

namespace boresight::sim {
namespace {

TEST(ParseInjection, ReadsKindAndOptions)
{
    const auto gust = parseInjection("wind,axis=az,at=5,for=2.5,value=-40");
    ASSERT_TRUE(gust);
    EXPECT_EQ(gust->kind, FaultKind::Wind);
    EXPECT_EQ(gust->axis, Axis::Azimuth);
    EXPECT_EQ(gust->at, Seconds(5.0));
    EXPECT_EQ(gust->duration, Seconds(2.5));
    EXPECT_EQ(gust->value, -40.0);
    const auto silence = parseInjection("silence");
    ASSERT_TRUE(silence);
    EXPECT_FALSE(silence->axis);
    EXPECT_EQ(silence->at, Seconds(0.0));
}

TEST(ParseInjection, RefusesWithAReason)
{
    for (const char* text : {"", "gremlins", "wind", "drive-fault,axis=el", "silence,for=0", "silence,at=-1",
                             "silence,axis=up", "silence,value=", "silence,,", "silence,value=nan", "wind,40"}) {
        const auto parsed = parseInjection(text);
        ASSERT_FALSE(parsed) << text;
        EXPECT_EQ(parsed.error().code, ErrorCode::InvalidInput);
        EXPECT_FALSE(parsed.error().text.empty());
    }
    EXPECT_NE(parseInjection("gremlins").error().text.find("power-loss"), std::string::npos) << "names what there is";
}

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
