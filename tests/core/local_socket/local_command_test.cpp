// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/local_socket/local_command.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

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

// REQ-LOCALSOCKET-930: A station of the own user is asked before the service of the system, whose socket is in the
// folder that systemd makes for it.
TEST(LocalCommandTest, TheServiceIsAskedWhereTheUserHasNoStation)
{
    constexpr std::uint16_t kPort = 4533;
    const QTemporaryDir user;
    const QTemporaryDir system;
    const QString own = socketPath(user.path(), kPort);
    const auto asked = [&] { return socketToAsk(user.path(), system.path(), kPort); };
    EXPECT_EQ(socketToAsk({}, system.path(), kPort), QString());
    EXPECT_EQ(asked(), own) << "it may come";
    ASSERT_TRUE(QDir(system.path()).mkdir(QStringLiteral("boresight")));
    EXPECT_EQ(asked(), socketPath(system.path(), kPort)) << "even if this user cannot see the socket";
    EXPECT_EQ(socketToAsk({}, system.path(), kPort), socketPath(system.path(), kPort));
    ASSERT_TRUE(QDir(user.path()).mkdir(QStringLiteral("boresight")));
    EXPECT_EQ(asked(), socketPath(system.path(), kPort)) << "the folder of a station that has ended";
    QFile socket(own);
    ASSERT_TRUE(socket.open(QIODevice::WriteOnly));
    EXPECT_EQ(asked(), own);
}

}  // namespace
}  // namespace boresight::local
