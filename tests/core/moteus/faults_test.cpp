// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/faults.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>
#include <vector>

namespace boresight::moteus {
namespace {

std::vector<int> definedCodes()
{
    std::vector<int> codes;
    for (const auto& [first, last] : {std::pair{0, 7}, std::pair{32, 50}, std::pair{96, 105}}) {
        for (int code = first; code <= last; ++code) {
            codes.push_back(code);
        }
    }
    return codes;
}

// REQ-MOTEUS-05 (MoteusFaults.*)
TEST(MoteusFaults, EveryDefinedCodeTellsNameMeaningCauseAndRemedy)
{
    std::set<std::string_view> names;
    std::set<std::string_view> meanings;
    for (const int code : definedCodes()) {
        const FaultText text = faultText(code);
        EXPECT_NE(text.name, "undefined code") << code;
        EXPECT_TRUE(names.insert(text.name).second) << code;
        EXPECT_TRUE(meanings.insert(text.meaning).second) << code;
        EXPECT_EQ(text.name.starts_with("limit: "), isLimit(code)) << code;
        for (const std::string_view sentence : {text.meaning, text.cause, text.remedy}) {
            EXPECT_GE(std::ranges::count(sentence, ' '), 1) << code << ": a word is no explanation: " << sentence;
            EXPECT_FALSE(sentence.ends_with('.')) << code;
            EXPECT_NE(std::toupper(sentence.front()) == sentence.front(), sentence.starts_with("servo")) << code;
        }
        EXPECT_NE(text.cause, text.meaning) << code;
        EXPECT_NE(text.cause, text.remedy) << code;
    }
    EXPECT_EQ(names.size(), 37U);  // 0..7, 32..50, 96..105
}

// This flag, not the words, marks a remedy that asks for a re-arm, so it works in every language.
TEST(MoteusFaults, ARemedyThatSaysWhenToReArmIsMarked)
{
    for (const int code : definedCodes()) {
        const FaultText text = faultText(code);
        EXPECT_EQ(text.saysRearm, text.remedy.find("re-arm") != std::string_view::npos) << code;
    }
}

TEST(MoteusFaults, AnyOtherCodeSaysThatItIsUndefined)
{
    const std::vector<int> defined = definedCodes();
    for (int code = -10; code < 300; ++code) {
        const bool known = std::ranges::binary_search(defined, code);
        EXPECT_EQ(faultText(code).name == "undefined code", !known) << code;
    }
    EXPECT_FALSE(faultText(8).cause.empty() || faultText(8).remedy.empty());
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
