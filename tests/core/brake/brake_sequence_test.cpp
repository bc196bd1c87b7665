// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/brake/brake_sequence.h"

#include <gtest/gtest.h>

namespace boresight::brake {
namespace {

// The output answers each order after `answerTime`.
class BrakeSequenceTest : public testing::Test
{
protected:
    void run(Seconds time)
    {
        constexpr Seconds kStep{0.02};
        for (int i = 0; i < static_cast<int>(time / kStep + 0.5); ++i) {
            now += std::chrono::duration_cast<SteadyTime::duration>(kStep);
            if (sequence.releases() != ordered) {
                ordered = sequence.releases();
                orderedAt = now;
                input.released.reset();
            }
            if (answers && now - orderedAt >= answerTime) {
                input.released = ordered;
            }
            sequence.step(input, times, now);
        }
    }
    // The set-points move as soon as they may.
    void move()
    {
        input.wanted = true;
        run(Seconds(1.0));
        ASSERT_TRUE(sequence.mayMove());
        input.wanted = false;
        input.moves = true;
        run(Seconds(1.0));
    }

    SteadyTime now{std::chrono::seconds(1000)};
    BrakeTimes times{
        .switching = Seconds(0.4), .setAfter = Seconds(5.0), .urgent = Seconds(0.0), .blind = Seconds(2.0)};
    BrakeInput input;
    BrakeSequence sequence;
    bool answers = true;
    Seconds answerTime{0.0};
    bool ordered = false;
    SteadyTime orderedAt{now};
};

// REQ-BRAKE-01: The brake is released only if a set-point would move. The set-points may move when the output has been
// on for the time that the brake needs, counted from the answer of the output.
TEST_F(BrakeSequenceTest, NothingMovesBeforeTheBrakeIsOpen)
{
    run(Seconds(60.0));
    EXPECT_EQ(sequence.state(), BrakeState::Set);
    EXPECT_FALSE(sequence.mayMove());
    answerTime = Seconds(1.0);
    input.wanted = true;
    run(Seconds(1.3));
    EXPECT_TRUE(sequence.releases());
    EXPECT_EQ(sequence.state(), BrakeState::Releasing);
    run(Seconds(0.2));
    EXPECT_EQ(sequence.state(), BrakeState::Released);
}

// REQ-BRAKE-01
TEST_F(BrakeSequenceTest, WithoutAnAnswerNothingMoves)
{
    answers = false;
    input.released.reset();
    input.wanted = true;
    run(Seconds(60.0));
    EXPECT_TRUE(sequence.releases());
    EXPECT_FALSE(sequence.mayMove());
}

// REQ-BRAKE-02: The brake is set after the time of the profile without motion. While an axis or a set-point moves, it
// stays released.
TEST_F(BrakeSequenceTest, IsSetAfterAPauseOfTheMotion)
{
    move();
    run(Seconds(600.0));
    EXPECT_TRUE(sequence.mayMove());
    input.moves = false;
    run(Seconds(4.9));
    EXPECT_TRUE(sequence.mayMove());
    input.moves = true;  // the pause begins again
    run(Seconds(0.1));
    input.moves = false;
    run(Seconds(4.9));
    EXPECT_TRUE(sequence.mayMove());
    run(Seconds(0.2));
    EXPECT_EQ(sequence.state(), BrakeState::Setting);
    EXPECT_FALSE(sequence.mayMove());
    run(Seconds(0.4));
    EXPECT_EQ(sequence.state(), BrakeState::Set);
}

// REQ-BRAKE-03: After STOP, after a fault and at the end of the program the brake is set at standstill, never before.
// If the brake is still opening, it is set at once.
TEST_F(BrakeSequenceTest, StopSetsItAtStandstill)
{
    move();
    input.isUrgent = true;
    run(Seconds(10.0));
    EXPECT_TRUE(sequence.releases()) << "the antenna still moves";
    input.moves = false;
    run(Seconds(0.02));
    EXPECT_FALSE(sequence.releases());
}

// REQ-BRAKE-03
TEST_F(BrakeSequenceTest, StopWhileItOpensSetsItAtOnce)
{
    input.wanted = true;
    run(Seconds(0.3));
    ASSERT_EQ(sequence.state(), BrakeState::Releasing);
    input.wanted = false;
    input.isUrgent = true;
    run(Seconds(0.02));
    EXPECT_FALSE(sequence.releases());
    run(Seconds(60.0));
    EXPECT_EQ(sequence.state(), BrakeState::Set);
}

// REQ-BRAKE-04: If nothing holds an axis, the brake is set at once, also while the antenna moves. It is not released
// while this lasts.
TEST_F(BrakeSequenceTest, HoldsAnAxisThatNothingElseHolds)
{
    move();
    input.isLimp = true;
    run(Seconds(0.02));
    EXPECT_FALSE(sequence.releases());
    input.wanted = true;
    run(Seconds(10.0));
    EXPECT_FALSE(sequence.releases());
}

// REQ-BRAKE-03
TEST_F(BrakeSequenceTest, AfterStopAnAxisWithStepsIsWatchedForLonger)
{
    times.urgent = Seconds(3.0);
    move();
    input.moves = false;
    input.isUrgent = true;
    run(Seconds(2.9));
    EXPECT_TRUE(sequence.releases());
    run(Seconds(0.2));
    EXPECT_FALSE(sequence.releases());
}

// REQ-BRAKE-32: A longer time to open, applied during a motion, does not interrupt that motion.
TEST_F(BrakeSequenceTest, IsOpenOnceItIsOpen)
{
    move();
    times.switching = Seconds(10.0);
    run(Seconds(0.02));
    EXPECT_TRUE(sequence.mayMove());
}

// REQ-BRAKE-05: A silent drive stops within a known time. If a drive is silent, the brake is set when the set-points
// have stood still for this time.
TEST_F(BrakeSequenceTest, ASilentDriveGetsTimeToStop)
{
    move();
    input.isBlind = true;
    input.isUrgent = true;
    input.moves = false;
    run(Seconds(1.9));
    EXPECT_TRUE(sequence.releases());
    run(Seconds(0.2));
    EXPECT_FALSE(sequence.releases());
}

// An answer to the order before does not count.
TEST_F(BrakeSequenceTest, AnOldAnswerDoesNotCount)
{
    move();
    input.moves = false;
    run(Seconds(5.1));
    ASSERT_FALSE(sequence.releases());
    answers = false;
    input.wanted = true;
    run(Seconds(10.0));
    EXPECT_TRUE(sequence.releases());
    EXPECT_FALSE(sequence.mayMove());
}

}  // namespace
}  // namespace boresight::brake
