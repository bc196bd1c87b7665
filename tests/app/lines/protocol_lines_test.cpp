// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/protocol_lines.h"

#include <gmock/gmock.h>

namespace boresight::ctl {
namespace {

// REQ-CTL-1001: `protocol-log follow` reports lines that the station does not keep any more. After Reconnect, when the
// station counts from 1 again, it reports that the log has begun again, and prints the new lines.
TEST(ProtocolPage, ContinuesAfterTheLastLine)
{
    const auto page = readProtocolPage(0, "1\tone\n2\ttwo\ttabs\n");
    ASSERT_TRUE(page);
    EXPECT_EQ(page->text, "one\ntwo\ttabs\n");
    EXPECT_EQ(page->last, 2);
    EXPECT_EQ(page->lost, 0);
    EXPECT_FALSE(page->isNewLog);
    const auto next = readProtocolPage(2, "6\tsix\n");
    ASSERT_TRUE(next);
    EXPECT_EQ(next->lost, 3);
    EXPECT_EQ(next->last, 6);
    EXPECT_EQ(readProtocolPage(6, {})->last, 6);
}

// REQ-CTL-1001
TEST(ProtocolPage, ALogThatBeganAgainIsNoticed)
{
    const auto page = readProtocolPage(700, "1\tone\n2\ttwo\n");
    ASSERT_TRUE(page);
    EXPECT_TRUE(page->isNewLog);
    EXPECT_EQ(page->text, "one\ntwo\n");
    EXPECT_EQ(page->last, 2);
    EXPECT_EQ(page->lost, 0);
}

TEST(ProtocolPage, AnUnreadableAnswerIsRefused)
{
    for (const char* bad : {"one\n", "1\tone", "x\tone\n", "\t\n"}) {
        EXPECT_FALSE(readProtocolPage(0, bad)) << bad;
    }
}

}  // namespace
}  // namespace boresight::ctl
