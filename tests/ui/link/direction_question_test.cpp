// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/direction_question.h"

#include <QSignalSpy>

#include <gtest/gtest.h>

namespace boresight::ui {
namespace {

constexpr SkyPointing kMast{68_deg, 30_deg};
constexpr SkyPointing kSouth{180_deg, 40_deg};

// A question, and a station that answers when the test says so.
class DirectionQuestionTest : public ::testing::Test
{
protected:
    DirectionQuestionTest() : question(desk), answers(&question, &DirectionQuestion::answered)
    {
        QObject::connect(&desk, &RequestDesk::requested, &desk,
                         [this](const NumberedRequest& request) { asked.push_back(request); });
        question.showStatus(status);
    }

    void answer(std::size_t number, const QString& whyNot)
    {
        desk.take({{.requestId = asked.at(number).id,
                    .verdict = DirectionVerdict{.whyNot = whyNot, .nearest = SkyPointing{75_deg, 30_deg}}}});
    }
    void showLater(std::chrono::milliseconds later)
    {
        status.utc += later;
        question.showStatus(status);
    }

    RequestDesk desk;
    DirectionQuestion question;
    QSignalSpy answers;
    std::vector<NumberedRequest> asked;
    StationStatus status;
};

// REQ-UI-921: The window shows the station's answer about this direction: why it is forbidden, and the nearest allowed
// one. It never shows an answer about another direction.
TEST_F(DirectionQuestionTest, TheAnswerIsShownWhenItComes)
{
    question.ask(kMast);
    ASSERT_EQ(asked.size(), 1U);
    EXPECT_EQ(std::get<request::JudgeDirection>(asked.front().request).direction, kMast);
    EXPECT_EQ(question.whyNot(), QString());
    answer(0, QStringLiteral("the mast"));
    EXPECT_EQ(answers.count(), 1);
    EXPECT_EQ(question.whyNot(), QStringLiteral("forbidden: the mast"));
    EXPECT_EQ(question.nearest(), (SkyPointing{75_deg, 30_deg}));
}

// REQ-UI-921
TEST_F(DirectionQuestionTest, AnAnswerAboutAnotherDirectionIsNeverShown)
{
    question.ask(kMast);
    question.ask(kSouth);
    answer(0, QStringLiteral("the mast"));
    EXPECT_EQ(question.whyNot(), QString());
    EXPECT_EQ(answers.count(), 0);
    answer(1, QStringLiteral("the hill"));
    EXPECT_EQ(question.whyNot(), QStringLiteral("forbidden: the hill"));
    question.ask(kMast);
    EXPECT_EQ(question.whyNot(), QString());
    EXPECT_FALSE(question.nearest());
    question.drop();
    answer(2, QStringLiteral("the mast"));
    EXPECT_EQ(question.whyNot(), QString());
}

// REQ-UI-922: The window asks again about a direction when the profile changes, and once a second.
TEST_F(DirectionQuestionTest, ItIsAskedAgainWithAnotherProfileAndOnceASecond)
{
    showLater(std::chrono::seconds(5));
    EXPECT_TRUE(asked.empty()) << "nobody wants to know";
    question.ask(kMast);
    answer(0, QStringLiteral("the mast"));
    showLater(std::chrono::milliseconds(900));
    EXPECT_EQ(asked.size(), 1U);
    showLater(std::chrono::milliseconds(100));
    ASSERT_EQ(asked.size(), 2U);
    EXPECT_EQ(question.whyNot(), QStringLiteral("forbidden: the mast")) << "until the next answer";
    showLater(std::chrono::seconds(5));
    EXPECT_EQ(asked.size(), 2U) << "a station that hangs is not asked over and over";
    status.profile = std::make_shared<const profile::Profile>();
    question.showStatus(status);
    ASSERT_EQ(asked.size(), 3U);
    answer(1, QStringLiteral("by the profile of before"));
    EXPECT_EQ(question.whyNot(), QStringLiteral("forbidden: the mast"));
    answer(2, {});
    EXPECT_EQ(question.whyNot(), QString());
}

TEST_F(DirectionQuestionTest, WithoutAMountThereIsNoVerdict)
{
    question.ask(kMast);
    desk.take({{.requestId = asked.front().id, .error = Error{ErrorCode::NotAvailable, QStringLiteral("no mount")}}});
    EXPECT_EQ(question.whyNot(), QString());
    showLater(std::chrono::seconds(1));
    EXPECT_EQ(asked.size(), 2U);
}

}  // namespace
}  // namespace boresight::ui
