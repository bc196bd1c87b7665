// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/response/sweep_response.h"

#include "tests/core/response/reason_of.h"
#include "tests/core/response/second_order.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>

namespace boresight::response {
namespace {

using ::testing::HasSubstr;

constexpr double kFrequency = 2.0;  // Hz, of the system
constexpr double kDamping = 0.5;

std::vector<Sample> swingAt(double hertz)
{
    const double omega = 2.0 * std::numbers::pi;
    auto samples = answerOf(omega * kFrequency, kDamping, 4.0 + 4.0 / hertz,
                            [=](double time) { return 0.3 * std::sin(omega * hertz * time) + 0.01 * time; });
    samples.erase(samples.begin(), samples.begin() + 100);  // removes the transient at the start
    return samples;
}

// REQ-TUNING-04: Gain and phase of each frequency of a sweep agree with the textbook.
TEST(SweepResponse, GainAndPhaseAreThoseOfTheTextbook)
{
    for (const double hertz : {0.3, 0.6, 1.2, 2.4, 4.0}) {
        const auto point = sweepPoint(swingAt(hertz), hertz);
        ASSERT_TRUE(point) << reasonOf(point);
        const double ratio = hertz / kFrequency;
        const double real = 1.0 - ratio * ratio;
        const double imaginary = 2.0 * kDamping * ratio;
        EXPECT_NEAR(point->gain, 1.0 / std::hypot(real, imaginary), 0.01) << hertz;
        EXPECT_NEAR(point->phase.degrees(), -std::atan2(imaginary, real) * 180.0 / std::numbers::pi, 1.0) << hertz;
        EXPECT_NEAR(point->amplitude.degrees(), 0.3, 0.002);
    }
}

// REQ-TUNING-04
TEST(SweepResponse, CountsOfAnEncoderDoNotMatterMuch)
{
    auto samples = swingAt(1.2);
    constexpr double kCount = 360.0 / 65536.0;
    for (Sample& one : samples) {
        one.actual = Angle::fromDegrees(std::floor(one.actual.degrees() / kCount) * kCount);
    }
    const auto exact = sweepPoint(swingAt(1.2), 1.2);
    const auto counted = sweepPoint(samples, 1.2);
    ASSERT_TRUE(exact && counted);
    EXPECT_NEAR(counted->gain, exact->gain, 0.005);
    EXPECT_NEAR(counted->phase.degrees(), exact->phase.degrees(), 0.5);
}

// REQ-TUNING-04
TEST(SweepResponse, RefusesWhatTellsNothing)
{
    EXPECT_FALSE(sweepPoint({}, 1.0));
    EXPECT_THAT(reasonOf(sweepPoint(swingAt(0.6), 0.05)), HasSubstr("too short"));
    const auto still = answerOf(20.0, 0.7, 3.0, [](double) { return 0.0; });
    EXPECT_THAT(reasonOf(sweepPoint(still, 1.0)), HasSubstr("hardly moved"));
}

}  // namespace
}  // namespace boresight::response
