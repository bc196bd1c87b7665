// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotator_box/place_filter.h"

#include "core/rotator_box/obedience_watch.h"

#include <gtest/gtest.h>

namespace boresight::gs232 {
namespace {

SteadyTime at(double seconds)
{
    return SteadyTime{} + std::chrono::round<SteadyTime::duration>(Seconds(100.0 + seconds));
}

// REQ-GS232-10: A single false position is ignored. Two positions that agree are accepted: the rotator has jumped.
TEST(PlaceFilter, OneFalseAngleIsLeftOut)
{
    PlaceFilter filter;
    EXPECT_FALSE(filter.take(180_deg, at(0.0)));
    EXPECT_FALSE(filter.place()) << "the first one waits for the second";
    EXPECT_FALSE(filter.take(181_deg, at(0.25)));
    EXPECT_EQ(filter.place(), 181_deg);
    EXPECT_FALSE(filter.take(18_deg, at(0.5))) << "a digit was lost";
    EXPECT_EQ(filter.place(), 181_deg);
    EXPECT_FALSE(filter.take(182_deg, at(0.75)));
    EXPECT_EQ(filter.place(), 182_deg);
}

TEST(PlaceFilter, AJumpOfAWholeTurnIsReportedOnce)
{
    PlaceFilter filter;
    (void)filter.take(40_deg, at(0.0));
    (void)filter.take(40_deg, at(0.25));
    EXPECT_FALSE(filter.take(400_deg, at(20.0)));
    const auto jump = filter.take(401_deg, at(20.25));
    ASSERT_TRUE(jump);
    EXPECT_EQ(jump->from, 40_deg);
    EXPECT_EQ(jump->to, 401_deg);
    EXPECT_FALSE(filter.take(402_deg, at(20.5)));
}

using Verdict = ObedienceWatch::Verdict;

TEST(ObedienceWatch, AnAxisThatStandsIsSentAgainAndThenStuck)
{
    ObedienceWatch watch;
    watch.place(10_deg, at(0.0));
    watch.sent(60_deg, at(0.0));
    EXPECT_EQ(watch.judge(at(1.9)), Verdict::Obeys);
    EXPECT_EQ(watch.judge(at(2.0)), Verdict::SendAgain);
    EXPECT_EQ(watch.judge(at(2.1)), Verdict::Obeys) << "once";
    watch.sent(61_deg, at(2.5));
    EXPECT_EQ(watch.judge(at(4.9)), Verdict::Obeys);
    EXPECT_EQ(watch.judge(at(5.0)), Verdict::Stuck) << "a target that moves on is no excuse";
}

TEST(ObedienceWatch, AStopIsRepeatedUntilTheAxisStands)
{
    ObedienceWatch watch;
    double degrees = 10.0;
    watch.place(10_deg, at(0.0));
    watch.stopped(at(0.0));
    int again = 0;
    Verdict last = Verdict::Obeys;
    for (double time = 0.25; time < 6.1 && last != Verdict::RunsOn; time += 0.25) {
        watch.place(Angle::fromDegrees(degrees += 1.5), at(time));
        last = watch.judge(at(time));
        again += last == Verdict::StopAgain ? 1 : 0;
    }
    EXPECT_EQ(again, 3);
    EXPECT_EQ(last, Verdict::RunsOn);
}

TEST(ObedienceWatch, AnAxisThatCoastsHasObeyed)
{
    ObedienceWatch watch;
    watch.place(10_deg, at(0.0));
    watch.stopped(at(0.0));
    watch.place(11_deg, at(0.3));
    for (double time = 0.5; time < 10.0; time += 0.25) {
        watch.place(11_deg, at(time));
        EXPECT_EQ(watch.judge(at(time)), Verdict::Obeys);
    }
    EXPECT_FALSE(watch.stopping()) << "it was seen to stand";
}

}  // namespace
}  // namespace boresight::gs232
