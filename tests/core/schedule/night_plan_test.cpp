// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/schedule/night_plan.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

namespace boresight::schedule {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

// `from` and `to` are seconds after the beginning of the plan.
WatchedPass pass(std::int64_t number, int from, int to, int priority = 1)
{
    WatchedPass one{.number = number, .priority = priority, .pass = {}};
    one.pass.aos.utc = UtcTime(std::chrono::seconds(from));
    one.pass.los.utc = UtcTime(std::chrono::seconds(to));
    one.pass.clear = {{one.pass.aos.utc, one.pass.los.utc}};
    return one;
}

// The numbers of the passes that are tracked completely.
std::vector<std::int64_t> chosen(const NightPlan& plan)
{
    std::vector<std::int64_t> numbers;
    for (const WatchedPass& one : plan.chosen) {
        if (!one.rest) {
            numbers.push_back(one.number);
        }
    }
    return numbers;
}

passes::Stretch stretch(int from, int to)
{
    return {.from = UtcTime(std::chrono::seconds(from)), .to = UtcTime(std::chrono::seconds(to))};
}

NightPlan plan(const std::vector<WatchedPass>& passes, OverlapPolicy policy = OverlapPolicy::Priority)
{
    return planNight(passes, {.policy = policy, .lead = Seconds(60.0)});
}

WatchedPass seenOnly(WatchedPass one, std::vector<std::pair<int, int>> parts)
{
    one.pass.clear.clear();
    for (const auto& [from, to] : parts) {
        one.pass.clear.push_back({UtcTime(std::chrono::seconds(from)), UtcTime(std::chrono::seconds(to))});
    }
    return one;
}

// REQ-SCHEDULE-900: If passes overlap, the policy chooses one of them: by priority, by length, or the earliest. Each
// omitted pass is listed with the pass that was chosen instead, and with the reason.
TEST(NightPlan, ThePolicyChoosesOneOfThoseThatOverlap)
{
    const std::vector<WatchedPass> passes{pass(1, 0, 500, 2), pass(2, 300, 600, 1), pass(3, 550, 1200, 3)};
    const NightPlan byPriority = plan(passes);
    EXPECT_THAT(chosen(byPriority), ElementsAre(2));
    ASSERT_THAT(byPriority.conflicts, SizeIs(2));
    EXPECT_EQ(byPriority.conflicts[0], (Conflict{.leftOut = passes[0],
                                                 .chosen = passes[1],
                                                 .reason = Reason::Priority,
                                                 .overlaps = true,
                                                 .rests = {stretch(0, 240)}}));
    EXPECT_EQ(byPriority.conflicts[1].leftOut, passes[2]);

    const NightPlan byLength = plan(passes, OverlapPolicy::Longest);
    EXPECT_THAT(chosen(byLength), ElementsAre(3)) << "50 s after the first are too short a lead";
    EXPECT_EQ(byLength.conflicts[0].reason, Reason::Longer);

    const NightPlan byBeginning = plan(passes, OverlapPolicy::First);
    EXPECT_THAT(chosen(byBeginning), ElementsAre(1));
    EXPECT_EQ(byBeginning.conflicts[0].reason, Reason::Earlier);
    EXPECT_FALSE(byBeginning.conflicts[1].overlaps);
}

// REQ-SCHEDULE-901: If two passes are equal under the policy, the next rule decides, at last the number of the
// satellite. The order of the given passes has no effect.
TEST(NightPlan, ATieIsDecidedTheSameWayEachTime)
{
    EXPECT_EQ(plan({pass(1, 0, 400), pass(2, 100, 600)}).conflicts[0].reason, Reason::Longer);
    EXPECT_EQ(plan({pass(1, 100, 500), pass(2, 0, 400)}).conflicts[0].reason, Reason::Earlier);
    const NightPlan same = plan({pass(2, 0, 400), pass(1, 0, 400)});
    EXPECT_THAT(chosen(same), ElementsAre(1));
    EXPECT_EQ(same.conflicts[0].reason, Reason::LowerNumber);

    std::mt19937 random(7);
    std::vector<WatchedPass> night;
    for (int i = 0; i < 60; ++i) {
        const int from = static_cast<int>(random() % 40'000);
        night.push_back(
            pass(i, from, from + 200 + static_cast<int>(random() % 500), 1 + static_cast<int>(random() % 3)));
    }
    for (const OverlapPolicy policy : {OverlapPolicy::Priority, OverlapPolicy::Longest, OverlapPolicy::First}) {
        const NightPlan first = plan(night, policy);
        EXPECT_EQ(chosen(first).size() + first.conflicts.size(), night.size());
        std::ranges::shuffle(night, random);
        EXPECT_EQ(plan(night, policy), first);
    }
}

// REQ-SCHEDULE-902: Two passes are both tracked if there is at least the lead time of the mount between them. A shorter
// gap is a conflict. A pass that is up when the plan begins needs no lead time.
TEST(NightPlan, TheMountIsInPlaceBeforeEachPass)
{
    EXPECT_THAT(chosen(plan({pass(1, 0, 400), pass(2, 460, 900)})), ElementsAre(1, 2));
    const NightPlan close = plan({pass(1, 0, 400), pass(2, 459, 800)});
    EXPECT_THAT(chosen(close), ElementsAre(1));
    EXPECT_FALSE(close.conflicts[0].overlaps);
    EXPECT_THAT(chosen(plan({pass(1, 0, 400), pass(2, 400, 800)})), ElementsAre(1)) << "back to back";

    WatchedPass up = pass(5, 0, 100);
    up.pass.isUpAtStart = true;
    EXPECT_THAT(chosen(plan({up, pass(6, 160, 500)})), ElementsAre(5, 6));
    EXPECT_THAT(plan({}).chosen, IsEmpty());
}

// REQ-SCHEDULE-907: The rest of an omitted pass, before, between or after the chosen passes, is tracked if it is
// visible for 60 s after the mount can be in place. A rest never prevents a complete pass. The conflict lists it.
TEST(NightPlan, TheRestOfAPassThatIsLeftOutIsTracked)
{
    const NightPlan after = plan({pass(1, 0, 400, 1), pass(2, 200, 600, 2)});
    ASSERT_THAT(after.chosen, SizeIs(2));
    EXPECT_EQ(after.chosen[1].number, 2);
    EXPECT_EQ(after.chosen[1].rest, stretch(400, 600)) << "the mount goes there at once";
    EXPECT_EQ(after.chosen[1].begins(), after.chosen[0].ends());
    EXPECT_THAT(after.conflicts[0].rests, ElementsAre(stretch(400, 600)));
    EXPECT_FALSE(after.conflicts[0].leftOut.rest);
    EXPECT_THAT(plan({pass(1, 0, 400, 1), pass(2, 200, 519, 2)}).chosen, SizeIs(1)) << "59 s after the lead";

    const NightPlan before = plan({pass(1, 300, 700, 1), pass(2, 0, 500, 2)});
    ASSERT_THAT(before.chosen, SizeIs(2));
    EXPECT_EQ(before.chosen[0].rest, stretch(0, 240)) << "the lead belongs to the chosen one";
    EXPECT_THAT(plan({pass(1, 119, 700, 1), pass(2, 0, 500, 2)}).chosen, SizeIs(1)) << "59 s before the lead";

    const NightPlan both = plan({pass(1, 1000, 1400, 1), pass(2, 0, 5000, 2), pass(3, 2000, 2300, 1)});
    EXPECT_THAT(chosen(both), ElementsAre(1, 3));
    EXPECT_THAT(both.conflicts[0].rests, ElementsAre(stretch(0, 940), stretch(1400, 1940), stretch(2300, 5000)));
    EXPECT_TRUE(std::ranges::is_sorted(both.chosen, {}, &WatchedPass::begins));

    // By priority alone the second pass would also prevent the third.
    EXPECT_THAT(chosen(plan({pass(1, 0, 400, 1), pass(2, 300, 900, 2), pass(3, 500, 1000, 3)})), ElementsAre(1, 3));
}

// REQ-SCHEDULE-907
TEST(NightPlan, OfARestOnlyWhatTheAntennaSeesCounts)
{
    const WatchedPass one = pass(1, 0, 400, 1);
    const NightPlan late = plan({one, seenOnly(pass(2, 200, 700, 2), {{200, 380}, {600, 700}})});
    ASSERT_THAT(late.chosen, SizeIs(2));
    EXPECT_EQ(late.chosen[1].begins(), UtcTime(std::chrono::seconds(600)));
    EXPECT_EQ(late.chosen[1].pass.clearTime(), Seconds(100.0));
    EXPECT_THAT(plan({one, seenOnly(pass(2, 200, 700, 2), {{200, 519}})}).chosen, SizeIs(1));
}

// REQ-SCHEDULE-907
TEST(NightPlan, NothingOfTheChosenPassesIsTakenByARest)
{
    std::mt19937 random(11);
    std::vector<WatchedPass> night;
    for (int i = 0; i < 80; ++i) {
        const int from = static_cast<int>(random() % 30'000);
        night.push_back(
            pass(i, from, from + 100 + static_cast<int>(random() % 900), 1 + static_cast<int>(random() % 3)));
    }
    const NightPlan all = plan(night);
    int rests = 0;
    for (std::size_t i = 1; i < all.chosen.size(); ++i) {
        const WatchedPass& before = all.chosen[i - 1];
        const WatchedPass& one = all.chosen[i];
        const Seconds gap = one.begins() - before.ends();
        EXPECT_GE(gap, Seconds(one.rest ? 0.0 : 60.0));
        rests += one.rest ? 1 : 0;
    }
    EXPECT_GT(rests, 10);
}

// REQ-SCHEDULE-905: The plan takes the horizon, the keep-outs and the limits of the mount into account. A pass counts
// only with the time in which the antenna sees it, and conflicts only between the first and the last of these moments.
// A pass that the antenna never sees is listed as hidden, and prevents no other pass.
TEST(NightPlan, WhatTheAntennaDoesNotSeeDoesNotCount)
{
    const WatchedPass second = pass(2, 300, 700, 2);
    EXPECT_THAT(chosen(plan({pass(1, 0, 400), second})), ElementsAre(1));
    EXPECT_THAT(chosen(plan({seenOnly(pass(1, 0, 400), {{20, 240}}), second})), ElementsAre(1, 2));
    EXPECT_THAT(chosen(plan({seenOnly(pass(1, 0, 400), {{20, 100}, {200, 241}}), second})), ElementsAre(1));

    const NightPlan hidden = plan({seenOnly(pass(1, 0, 400), {}), second});
    EXPECT_THAT(chosen(hidden), ElementsAre(2));
    EXPECT_THAT(hidden.conflicts, IsEmpty());
    ASSERT_THAT(hidden.hidden, SizeIs(1));
    EXPECT_EQ(hidden.hidden[0].number, 1);

    const NightPlan byLength =
        plan({seenOnly(pass(1, 0, 500), {{0, 50}, {450, 500}}), pass(2, 300, 700)}, OverlapPolicy::Longest);
    EXPECT_THAT(chosen(byLength), ElementsAre(2)) << "100 s are seen of the first";
    EXPECT_EQ(byLength.conflicts[0].reason, Reason::Longer);
}

TEST(NightPlan, APassThatIsLeftOutKeepsBackNoOther)
{
    const NightPlan all = plan({pass(1, 0, 300, 1), pass(2, 250, 700, 2), pass(3, 650, 900, 3)});
    EXPECT_THAT(chosen(all), ElementsAre(1, 3));
}

}  // namespace
}  // namespace boresight::schedule
