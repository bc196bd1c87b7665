// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pass_report/pass_trace.h"

#include "tests/core/pass_report/driven_pass.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace boresight::pass_report {
namespace {

using recording::Recording;

// REQ-REPORT-08: A line of the report shows a peak of one tick, however long the pass is.
TEST(PassTraceTest, AThinnedLineKeepsItsPeak)
{
    std::vector<double> errors(9000, 0.1);
    errors[4321] = 3.0;
    errors[4322] = 0.01;
    const TraceLine line = traceOf(drivenPass(errors), 50).error;
    ASSERT_EQ(line.size(), 1U);
    EXPECT_LE(line[0].size(), 2U * 51U);
    const auto [least, largest] = std::ranges::minmax_element(line[0], {}, &TracePoint::value);
    EXPECT_NEAR(largest->value, 3.0, 1e-9);
    EXPECT_NEAR(largest->since.count(), 432.1, 1e-9);
    EXPECT_NEAR(least->value, 0.01, 1e-9);
    EXPECT_TRUE(std::ranges::is_sorted(line[0], {}, &TracePoint::since));
}

TEST(PassTraceTest, AMeanIsThatOfItsColumn)
{
    Recording recording = drivenPass();
    recording.ticks[1].axes[1].torque = 2.5;  // one of 10 in the first of 4 columns
    const TraceLine mean = traceOf(recording, 4 * kMeanOver).meanTorque[1];
    ASSERT_EQ(mean.size(), 1U);
    ASSERT_EQ(mean[0].size(), 4U);
    EXPECT_NEAR(mean[0][0].value, 0.7, 1e-9);
    EXPECT_NEAR(mean[0][0].since.count(), 0.45, 1e-9);
    EXPECT_NEAR(mean[0][1].value, 0.5, 1e-9);
}

TEST(PassTraceTest, AnUnknownPartInterruptsALine)
{
    Recording recording = drivenPass();
    recording.ticks[12].axes[0].torque.reset();
    recording.ticks[20].target.reset();
    for (std::size_t i = 25; i < recording.ticks.size(); ++i) {
        recording.ticks[i].utc += std::chrono::seconds(2);
    }
    const PassTrace trace = traceOf(recording, 1000);
    EXPECT_EQ(trace.torque[0].size(), 3U);
    EXPECT_EQ(trace.torque[1].size(), 2U);
    EXPECT_EQ(trace.target.size(), 3U);
    EXPECT_EQ(trace.beam.size(), 2U);
    EXPECT_TRUE(traceOf(drivenPass({}), 10).error.empty());
}

// REQ-REPORT-09: The sky of the report has the planned path of the beam.
TEST(PassTraceTest, ThePlanStandsOnTheSky)
{
    Recording recording = drivenPass();
    recording.plan = planOfDrivenPass(0, 39);
    const SkyLine plan = traceOf(recording, 100).plan;
    ASSERT_EQ(plan.size(), 1U);
    ASSERT_EQ(plan[0].size(), 40U);
    EXPECT_NEAR(plan[0][4].azimuth.degrees(), 99.5, 1e-6);
    EXPECT_NEAR(plan[0][4].elevation.degrees(), 14.0, 1e-6);
    // The axes of an X/Y mount do not follow azimuth and elevation.
    recording.ticks[7].axes[0].actual = Angle::fromDegrees(10.0);
    EXPECT_TRUE(traceOf(recording, 100).plan.empty());
}

TEST(PassTraceTest, OverTheTopIsADirection)
{
    const SkyPointing beam = upright({Angle::fromDegrees(200.0), Angle::fromDegrees(120.0)});
    EXPECT_NEAR(beam.azimuth.degrees(), 20.0, 1e-9);
    EXPECT_NEAR(beam.elevation.degrees(), 60.0, 1e-9);
}

}  // namespace
}  // namespace boresight::pass_report
