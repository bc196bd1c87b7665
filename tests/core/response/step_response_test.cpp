// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/response/step_response.h"

#include "tests/core/response/reason_of.h"
#include "tests/core/response/second_order.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

namespace boresight::response {
namespace {

using ::testing::HasSubstr;

constexpr double kOmega = 5.0;  // rad/s: slow compared with the sampling, so no sample misses the peak

std::vector<Sample> stepOf(double damping, double degrees = 2.0)
{
    return answerOf(
        kOmega, damping, 6.0, [=](double) { return degrees; }, 0.1);
}

// REQ-TUNING-01: Overshoot and settling time of a step agree with the textbook for a second-order system.
TEST(StepResponse, OvershootIsThatOfTheTextbook)
{
    for (const double damping : {0.2, 0.3, 0.5, 0.7}) {
        const auto figures = stepFigures(stepOf(damping), 0.04_deg);
        ASSERT_TRUE(figures) << reasonOf(figures);
        const double known = std::exp(-damping * std::numbers::pi / std::sqrt(1.0 - damping * damping));
        EXPECT_NEAR(figures->overshoot, known, 0.003) << damping;
    }
}

// REQ-TUNING-01
TEST(StepResponse, CriticallyDampedSettlesWhenTheTextbookSays)
{
    const auto figures = stepFigures(stepOf(1.0), 0.04_deg);  // 2 %
    ASSERT_TRUE(figures) << reasonOf(figures);
    EXPECT_DOUBLE_EQ(figures->overshoot, 0.0);
    ASSERT_TRUE(figures->settling);
    EXPECT_NEAR(figures->settling->count(), 5.834 / kOmega, 0.021);  // (1 + x) e^-x = 0.02
    EXPECT_NEAR(figures->left.degrees(), 0.0, 1e-6);
}

// REQ-TUNING-01
TEST(StepResponse, ReadsTheSameDownwards)
{
    const auto up = stepFigures(stepOf(0.3, 2.0), 0.04_deg);
    const auto down = stepFigures(stepOf(0.3, -2.0), 0.04_deg);
    ASSERT_TRUE(up && down);
    EXPECT_NEAR(up->overshoot, down->overshoot, 1e-9);
    EXPECT_NEAR(up->settling->count(), down->settling->count(), 1e-9);
    EXPECT_NEAR(down->size.degrees(), -2.0, 1e-9);
    EXPECT_NEAR(down->error.peak.degrees(), 2.0, 1e-9);
}

// REQ-TUNING-02: The settling time counts from the moment when a moving set-point arrives.
TEST(StepResponse, CountsFromTheArrivalOfTheSetpoint)
{
    const auto slow = answerOf(40.0, 1.0, 4.0, [](double time) { return std::min(time, 2.0); });
    const auto figures = stepFigures(slow, 0.04_deg);
    ASSERT_TRUE(figures && figures->settling);
    EXPECT_LT(figures->settling->count(), 0.1);  // a lag of 0.05° that fades in about 25 ms
    EXPECT_NEAR(figures->error.peak.degrees(), 2.0 / 40.0, 0.002);
}

// REQ-TUNING-02
TEST(StepResponse, TellsWhatNeverSettles)
{
    const auto figures = stepFigures(stepOf(0.01), 0.04_deg);
    ASSERT_TRUE(figures) << reasonOf(figures);
    EXPECT_FALSE(figures->settling);
}

// REQ-TUNING-02
TEST(StepResponse, RefusesWhatTellsNothing)
{
    EXPECT_FALSE(stepFigures({}, 0.04_deg));
    auto samples = stepOf(1.0);
    samples.resize(8);
    EXPECT_THAT(reasonOf(stepFigures(samples, 0.04_deg)), HasSubstr("is too short"));
    EXPECT_THAT(reasonOf(stepFigures(stepOf(1.0, 0.01), 0.04_deg)), HasSubstr("not larger than"));
}

}  // namespace
}  // namespace boresight::response
