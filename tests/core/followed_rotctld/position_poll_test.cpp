// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/followed_rotctld/position_poll.h"

#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

namespace boresight::rotctl {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

class PositionPollTest : public testing::Test
{
protected:
    // The reply to one query.
    std::optional<Result<AxisPosition>> answerTo(std::string_view bytes)
    {
        EXPECT_EQ(poll.ask(now), "p\n");
        poll.take(bytes);
        now += PositionPoll::kPeriod;
        return poll.takeAnswer();
    }
    std::string problem(std::string_view bytes)
    {
        const auto answer = answerTo(bytes);
        return answer && !*answer ? textOf(answer->error()) : std::string();
    }

    PositionPoll poll;
    SteadyTime now{seconds(100)};
};

// REQ-ROTATORFOLLOW-01: The position is queried with p, at most four times a second, one query at a time.
TEST_F(PositionPollTest, OneQuestionAtATime)
{
    EXPECT_EQ(poll.ask(now), "p\n");
    EXPECT_EQ(poll.ask(now + seconds(2)), "") << "the answer is awaited";
    EXPECT_FALSE(poll.hangs(now + PositionPoll::kPatience));
    EXPECT_TRUE(poll.hangs(now + PositionPoll::kPatience + milliseconds(1)));
    poll.take("120.5");
    EXPECT_FALSE(poll.takeAnswer());
    poll.take("0\n45.25\n");
    EXPECT_EQ(poll.ask(now + PositionPoll::kPeriod - milliseconds(1)), "");
    EXPECT_EQ(poll.ask(now + PositionPoll::kPeriod), "p\n");
    const auto answer = poll.takeAnswer();
    ASSERT_TRUE(answer && *answer);
    EXPECT_EQ((*answer)->azimuth, 120.5_deg);
    EXPECT_EQ((*answer)->elevation, 45.25_deg);
    EXPECT_FALSE(poll.takeAnswer()) << "once";
}

// REQ-ROTATORFOLLOW-02: An error of Hamlib is reported in words. A reply that is not from a rotctld is refused with its
// text. Half a position is refused.
TEST_F(PositionPollTest, TellsWhatIsNoPosition)
{
    EXPECT_EQ(problem("RPRT -5\n"), "the rotator did not answer rotctld in time (RPRT -5)");
    EXPECT_EQ(problem("SSH-2.0-OpenSSH\r\n"), "The answer \"SSH-2.0-OpenSSH\" is not from a rotctld");
    EXPECT_EQ(problem("nan\n45\n"), "The answer \"nan\" is not from a rotctld");
    EXPECT_EQ(problem("12\nRPRT -1\n"), "The answer \"RPRT -1\" is not from a rotctld");
    EXPECT_EQ(problem("1e9\n0\n"), "The answer \"1e9\" is not from a rotctld");
    EXPECT_EQ(poll.ask(now), "p\n");
    poll.take("12\n");
    poll.restart();
    EXPECT_EQ(poll.ask(now), "p\n") << "of a new connection";
    poll.take("13\n14\n");
    const auto answer = poll.takeAnswer();
    ASSERT_TRUE(answer && *answer);
    EXPECT_EQ((*answer)->azimuth, 13_deg);
}

// REQ-ROTATORFOLLOW-03: A line without a query is no position.
TEST_F(PositionPollTest, ALineThatNobodyAskedForIsNone)
{
    poll.take("10\n20\n");
    EXPECT_FALSE(poll.takeAnswer());
    const auto answer = answerTo("30\n40\nRPRT 0\n50\n60\n");
    ASSERT_TRUE(answer && *answer);
    EXPECT_EQ((*answer)->azimuth, 30_deg);
    EXPECT_FALSE(poll.takeAnswer());
}

}  // namespace
}  // namespace boresight::rotctl
