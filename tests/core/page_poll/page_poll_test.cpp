// SPDX-License-Identifier: GPL-3.0-or-later
// With a real web server.
#include "core/page_poll/page_poll.h"

#include "tests/fakes/canned_web.h"
#include "tests/fakes/wait_until.h"

#include <gmock/gmock.h>

#include <memory>
#include <vector>

namespace boresight::page {
namespace {

using testing::HasSubstr;

class PagePollTest : public ::testing::Test
{
protected:
    void begin(std::chrono::milliseconds period = std::chrono::milliseconds(20))
    {
        const QUrl url(QString::fromStdString(web.address("/wind?key=secret")));
        poll = std::make_unique<PagePoll>(QStringLiteral("test"), url, period);
        QObject::connect(poll.get(), &PagePoll::received, poll.get(),
                         [this](const QByteArray& page) { pages.push_back(page); });
    }
    void answers(const QByteArray& status, const QByteArray& content, const QByteArray& headers = {})
    {
        web.answersWith("/wind?key=secret", status, headers, content);
    }

    fakes::CannedWeb web;
    std::unique_ptr<PagePoll> poll;
    std::vector<QByteArray> pages;
};

// REQ-PAGE-01: The page is read at once, and again after each period.
TEST_F(PagePollTest, ThePageIsReadAgainAndAgain)
{
    answers("200 OK", "12.3\n");
    begin();
    ASSERT_TRUE(fakes::waitUntil([this] { return pages.size() >= 3; }));
    EXPECT_THAT(pages, testing::Each(QByteArray("12.3\n")));
    EXPECT_EQ(poll->trouble(), QString());
}

// REQ-PAGE-02: If a server refuses, redirects or does not answer, this is reported, and the page is requested again.
// The report leaves out the part of the address after the question mark.
TEST_F(PagePollTest, ATroubleIsReported)
{
    const auto reports = [this](const char* words) {
        return fakes::waitUntil([&] { return poll->trouble().contains(QLatin1String(words)); });
    };
    answers("404 Not Found", "12.3");
    begin();
    EXPECT_TRUE(reports("Not Found"));
    answers("302 Found", "12.3", "Location: /other\r\n");
    EXPECT_TRUE(reports("The server answers 302."));
    EXPECT_FALSE(poll->trouble().contains(QLatin1String("secret")));
    EXPECT_TRUE(pages.empty());
    answers("200 OK", "5");
    EXPECT_TRUE(fakes::waitUntil([this] { return !pages.empty() && poll->trouble().isEmpty(); }));
    web.stopListening();
    EXPECT_TRUE(fakes::waitUntil([this] { return !poll->trouble().isEmpty(); }));
}

// REQ-PAGE-03: Of an endless page 4097 bytes are read, so the reader can detect that it is too long.
TEST_F(PagePollTest, APageWithoutAnEndIsCut)
{
    web.answers("/wind?key=secret", "HTTP/1.1 200 OK\r\nConnection: close\r\n\r\n12.3", fakes::CannedWeb::Then::GoesOn);
    begin(std::chrono::minutes(1));
    ASSERT_TRUE(fakes::waitUntil([this] { return !pages.empty(); }));
    EXPECT_EQ(pages.front().size(), PagePoll::kLongest + 1);
}

// The thread ends while a request is pending.
TEST_F(PagePollTest, EndsWhileTheServerSaysNothing)
{
    web.answers("/wind?key=secret", "HTTP/1.1 200 OK\r\n\r\n", fakes::CannedWeb::Then::Waits);
    begin();
    ASSERT_TRUE(fakes::waitUntil([this] { return !web.questions().empty(); }));
    poll.reset();
    EXPECT_TRUE(pages.empty());
}

}  // namespace
}  // namespace boresight::page
