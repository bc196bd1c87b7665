// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/faults.h"

#include <gtest/gtest.h>

#include <set>

namespace boresight::moteus {
namespace {

TEST(MoteusFaults, EveryDefinedCodeHasItsOwnNameAndARemedy)
{
    std::set<std::string_view> names;
    for (int code = -10; code < 300; ++code) {
        const FaultText text = faultText(code);
        EXPECT_FALSE(text.name.empty() || text.meaning.empty() || text.remedy.empty()) << code;
        const bool defined = (code >= 0 && code <= 7) || (code >= 32 && code <= 50) || isLimit(code);
        EXPECT_EQ(text.name != "undefined code", defined) << code;
        EXPECT_TRUE(!defined || names.insert(text.name).second) << code;
    }
    EXPECT_EQ(names.size(), 37U);  // 0..7, 32..50, 96..105
}

TEST(MoteusFaults, LimitsAreNoFaults)
{
    EXPECT_FALSE(isLimit(95));
    EXPECT_TRUE(isLimit(96));
    EXPECT_TRUE(isLimit(105));
    EXPECT_FALSE(isLimit(106));
    EXPECT_EQ(faultText(103).name, "limit: position bounds");
    EXPECT_EQ(faultText(38).name, "over temperature");
}

TEST(MoteusFaults, OnlyFaultAndTimeoutNeedAStop)
{
    for (int mode = 0; mode < kModeCount; ++mode) {
        EXPECT_EQ(needsStop(static_cast<Mode>(mode)), mode == 1 || mode == 11);
        EXPECT_NE(modeText(static_cast<Mode>(mode)), "undefined mode");
    }
    EXPECT_EQ(modeText(static_cast<Mode>(16)), "undefined mode");
    EXPECT_EQ(modeText(Mode::PositionTimeout), "watchdog expired");
}

}  // namespace
}  // namespace boresight::moteus
