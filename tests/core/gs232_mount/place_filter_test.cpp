// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotator_box/place_filter.h"

#include "core/rotator_box/obedience_watch.h"

#include <gtest/gtest.h>

#include <cmath>

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
    ObedienceWatch watch(2_deg);
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
    ObedienceWatch watch(2_deg);
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
    ObedienceWatch watch(2_deg);
    watch.place(10_deg, at(0.0));
    watch.stopped(at(0.0));
    watch.place(11_deg, at(0.3));
    for (double time = 0.5; time < 10.0; time += 0.25) {
        watch.place(11_deg, at(time));
        EXPECT_EQ(watch.judge(at(time)), Verdict::Obeys);
    }
    EXPECT_FALSE(watch.stopping()) << "it was seen to stand";
}

// REQ-GS232-67
TEST(ObedienceWatch, ALostStopOfASlowMotorIsRepeated)
{
    for (const double speed : {0.7, 1.0, 1.4}) {
        for (const bool obeys : {true, false}) {
            ObedienceWatch watch(2_deg);
            watch.place(10_deg, at(0.0));
            watch.stopped(at(0.0));
            int again = 0;
            bool runsOn = false;
            double place = 10.0;
            for (double time = 0.25; time < 12.0; time += 0.25) {
                place += obeys && again > 0 ? 0.0 : 0.25 * speed;
                watch.place(Angle::fromDegrees(std::floor(place)), at(time));
                const Verdict verdict = watch.judge(at(time));
                again += verdict == Verdict::StopAgain ? 1 : 0;
                runsOn = runsOn || verdict == Verdict::RunsOn;
            }
            EXPECT_GE(again, 1) << speed;
            EXPECT_EQ(runsOn, !obeys) << speed;
            EXPECT_EQ(watch.stopping(), !obeys) << speed;
        }
    }
}

TEST(ObedienceWatch, TheNoiseOfAWornPotentiometerIsNoLostStop)
{
    ObedienceWatch watch(2_deg);
    watch.place(10_deg, at(0.0));
    watch.stopped(at(0.0));
    for (int count = 1; count < 60; ++count) {
        const double noise = count > 18 ? count % 3 - 1.0 : count % 2;  // one count appears late
        watch.place(Angle::fromDegrees(10.0 + noise), at(0.25 * count));
        EXPECT_EQ(watch.judge(at(0.25 * count)), Verdict::Obeys) << count;
    }
    EXPECT_FALSE(watch.stopping());
}

}  // namespace
}  // namespace boresight::gs232
