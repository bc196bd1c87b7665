// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/local_socket/local_command.h"

#include <gtest/gtest.h>

namespace boresight::local {
namespace {

// REQ-LOCALSOCKET-01: The commands are take, release, stop and reset-stop, exactly. The answer is one line: ok, or
// error with the reason.
TEST(LocalCommandTest, EachHasItsWord)
{
    for (const char* const word : {"take", "release", "stop", "reset-stop"}) {
        const auto command = parseCommand(word);
        ASSERT_TRUE(command) << word;
        EXPECT_EQ(wordOf(*command), word);
        EXPECT_EQ(parseCommand(QByteArray(word) + "\r"), *command) << word;
    }
    for (const char* const other : {"", "Stop", "stop now", "reset_stop", "P 10 20", "take\nstop"}) {
        EXPECT_FALSE(parseCommand(other)) << other;
    }
}

// REQ-LOCALSOCKET-01
TEST(LocalCommandTest, TheAnswerIsOneLine)
{
    EXPECT_EQ(answerLine({}), "ok\n");
    const Result<> refused = failure(ErrorCode::Refused, QStringLiteral("STOP is latched.\nReset STOP first."));
    EXPECT_EQ(answerLine(refused), "error: STOP is latched. Reset STOP first.\n");
    EXPECT_TRUE(parseAnswer("ok\n"));
    const auto reason = parseAnswer(answerLine(refused));
    ASSERT_FALSE(reason);
    EXPECT_EQ(reason.error().code, ErrorCode::Refused);
    EXPECT_EQ(reason.error().text, QStringLiteral("STOP is latched. Reset STOP first."));
    EXPECT_EQ(parseAnswer("RPRT 0\n").error().code, ErrorCode::Protocol);
}

}  // namespace
}  // namespace boresight::local
