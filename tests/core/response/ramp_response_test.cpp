// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/response/ramp_response.h"

#include "tests/core/response/reason_of.h"
#include "tests/core/response/second_order.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace boresight::response {
namespace {

using ::testing::HasSubstr;

// REQ-TUNING-03: A ramp is evaluated where its rate is constant. The lag of a second-order system is 2 z / w times the
// rate.
TEST(RampResponse, LagIsThatOfTheTextbook)
{
    for (const double rate : {0.5, -1.0}) {
        const auto samples = answerOf(
            20.0, 0.7, 6.0, [=](double time) { return rate * std::clamp(time, 0.0, 4.0); }, 0.5);
        const auto figures = rampFigures(samples);
        ASSERT_TRUE(figures) << reasonOf(figures);
        const double lag = 2.0 * 0.7 / 20.0 * std::abs(rate);
        EXPECT_NEAR(figures->rate.degrees(), rate, 1e-6);
        EXPECT_NEAR(figures->lag.degrees(), lag, 0.001);
        EXPECT_NEAR(figures->steady.rms.degrees(), lag, 0.001);
        EXPECT_GE(figures->error.peak, figures->steady.peak);
        ASSERT_TRUE(figures->torque);
        EXPECT_NEAR(figures->torque->rms, std::abs(rate), 0.01);
    }
}

// REQ-TUNING-03
TEST(RampResponse, RefusesWhatNeverMovesOn)
{
    EXPECT_FALSE(rampFigures({}));
    const auto still = answerOf(20.0, 0.7, 3.0, [](double) { return 0.0; });
    EXPECT_THAT(reasonOf(rampFigures(still)), HasSubstr("constant rate"));
}

}  // namespace
}  // namespace boresight::response
