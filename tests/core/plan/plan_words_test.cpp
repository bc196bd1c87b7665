// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/plan_words.h"

#include <gtest/gtest.h>

namespace boresight::plan {
namespace {

PlanVariant variantWith(PlanWay way, Angle peak, std::optional<double> loss, Seconds beyond = {})
{
    PlanVariant variant{.way = way};
    variant.forecast = {.peak = peak, .beyond = beyond, .peakLoss = loss};
    return variant;
}

// REQ-PASSES-17: What is tracked is shown with its plan in words, if the plan is more than to follow the target.
TEST(PlanWords, ASummaryHasTheWayAndTheError)
{
    const PlanVariant top = variantWith(PlanWay::OverTheTop, Angle::fromDegrees(0.1), 0.005);
    EXPECT_EQ(summaryText(top).toStdString(), "Over the top, off by up to 0.10° (−0.0 dB)");
    EXPECT_FALSE(isPlain(top));
    const PlanVariant ramp = variantWith(PlanWay::Direct, Angle::fromDegrees(5.3), std::nullopt, Seconds(14.0));
    EXPECT_EQ(summaryText(ramp).toStdString(), "Direct, off by up to 5.30° (beyond the beam)");
    EXPECT_FALSE(isPlain(ramp));
    const PlanVariant turns = variantWith(PlanWay::Unwraps, 130_deg, std::nullopt, Seconds(37.0));
    EXPECT_EQ(summaryText(turns).toStdString(), "Unwraps in the pass, off target for 37 s");
    EXPECT_TRUE(isPlain(variantWith(PlanWay::Direct, Angle::fromDegrees(0.02), 0.001)));
}

}  // namespace
}  // namespace boresight::plan
