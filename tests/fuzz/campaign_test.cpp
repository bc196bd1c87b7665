// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/campaign.h"

#include "tests/fuzz/harness.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace boresight::fuzz {
namespace {

enum class Does
{
    Nothing,
    Computes,  // for ever
    Waits      // for ever
};

Does does = Does::Nothing;

// In the first of three inputs.
Outcome runWith(Does what, const Campaign& limits)
{
    does = what;
    return run({.inputs = 3, .seed = 1, .mostProcessorTime = limits.mostProcessorTime, .longest = limits.longest});
}

// REQ-FUZZ-01: An input is judged by its processor time. Other load of the computer causes no failure, and an input
// that waits for ever is also found.
TEST(FuzzCampaign, AnInputIsJudgedByItsProcessorTime)
{
    using std::chrono::seconds;
    EXPECT_FALSE(runWith(Does::Nothing, {}).failure);
    const Outcome computes = runWith(Does::Computes, {.mostProcessorTime = seconds(1), .longest = seconds(300)});
    ASSERT_TRUE(computes.failure);
    EXPECT_EQ(computes.failure->how, "not done after 1 s of processor time");
    EXPECT_EQ(computes.failure->number, 0U);
    EXPECT_FALSE(computes.failure->input.empty());
    const Outcome waits = runWith(Does::Waits, {.mostProcessorTime = seconds(300), .longest = seconds(1)});
    ASSERT_TRUE(waits.failure);
    EXPECT_EQ(waits.failure->how, "not done after 1 s");
}

}  // namespace

Grammar grammar()
{
    return {.corpus = {"abcdefgh"}, .tokens = {"x"}, .maxLength = 20};
}

void feed(std::span<const std::uint8_t>)
{
    static std::atomic<unsigned> count = 0;
    while (does == Does::Computes) {
        ++count;
    }
    while (does == Does::Waits) {
        std::this_thread::sleep_for(std::chrono::hours(1));
    }
}

}  // namespace boresight::fuzz
