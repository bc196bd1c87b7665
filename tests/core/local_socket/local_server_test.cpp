// SPDX-License-Identifier: GPL-3.0-or-later
// Real sockets in a folder of the test. The clock is turned by hand.
#include "core/local_socket/local_server.h"

#include "core/base/file_descriptor.h"
#include "tests/fakes/hand_turned_timers.h"
#include "tests/fakes/wait_until.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

namespace boresight::local {
namespace {

using fakes::waitUntil;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

constexpr std::uint16_t kPort = 4533;

mode_t rightsOf(const QString& path)
{
    constexpr mode_t kRights = 0777;
    struct stat found = {};
    return ::stat(QFile::encodeName(path).constData(), &found) == 0 ? found.st_mode & kRights : 0;
}

class LocalServerTest : public testing::Test
{
protected:
    static constexpr std::size_t kRoom = 256;  // for an answer
    static constexpr qsizetype kMany = 4'000'000;

    [[nodiscard]] Result<> listen() { return server.listen(runtime.path(), kPort); }

    // Connects, and waits until the server has taken the connection.
    [[nodiscard]] std::unique_ptr<QLocalSocket> client(int isNumber)
    {
        auto socket = std::make_unique<QLocalSocket>();
        socket->connectToServer(server.path());
        EXPECT_TRUE(waitUntil([&] { return server.findChildren<LocalConversation*>().size() == isNumber; }));
        return socket;
    }
    static std::string answerTo(QLocalSocket& socket, const QByteArray& sent)
    {
        socket.write(sent);
        EXPECT_TRUE(waitUntil([&] { return socket.state() == QLocalSocket::UnconnectedState; })) << "stays open";
        return socket.readAll().toStdString();
    }
    std::string ask(const QByteArray& sent)
    {
        QLocalSocket socket;
        socket.connectToServer(server.path());
        return answerTo(socket, sent);
    }
    // Leaves a socket like a program that was killed.
    void leaveASocket() const
    {
        ASSERT_TRUE(QDir(runtime.path()).mkpath(QStringLiteral("boresight")));
        const FileDescriptor dead(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
        ASSERT_EQ(withAddress(::bind, dead), 0);
        ASSERT_TRUE(QFile::exists(path));
    }
    // bind() or connect() at the path.
    int withAddress(int (*call)(int, const sockaddr*, socklen_t), const FileDescriptor& socket) const
    {
        sockaddr_un address = {};
        address.sun_family = AF_UNIX;
        const QByteArray name = QFile::encodeName(path);
        std::ranges::copy(name, address.sun_path);
        const void* const untyped = &address;
        return call(socket.number(), static_cast<const sockaddr*>(untyped), sizeof address);
    }

    QTemporaryDir runtime;
    const QString path = socketPath(runtime.path(), kPort);
    LocalAnswer agreement;
    std::vector<LocalCommand> asked;
    bool answersLater = false;
    Reply later;
    LocalServer server{[this](const LocalRequest& request, const Reply& reply) {
        asked.push_back(request.command);
        later = answersLater ? reply : Reply();
        if (!answersLater) {
            reply(agreement);
        }
    }};
    fakes::ManualClock clock;
    fakes::HandTurnedTimers timers{server, clock};
};

// REQ-LOCALSOCKET-02: A connection sends one command and receives one line: ok, or error with the reason of the
// station. Text that is no command, or is longer than 4352 bytes, never reaches the station.
TEST_F(LocalServerTest, OneLineInOneLineOut)
{
    ASSERT_TRUE(listen());
    EXPECT_EQ(ask("take\n"), "ok\n");
    EXPECT_EQ(ask("stop\nreset-stop\n"), "ok\n");
    agreement = failure(ErrorCode::Refused, QStringLiteral("STOP is latched. Reset STOP first."));
    EXPECT_EQ(ask("release\n"), "error: STOP is latched. Reset STOP first.\n");
    EXPECT_THAT(asked, ElementsAre(LocalCommand::Take, LocalCommand::Stop, LocalCommand::Release));
    asked.clear();
    EXPECT_EQ(ask("P 10 20\n"),
              "error: This is not a command. The commands are take, release, stop, reset-stop, override-wind, "
              "use-new-time, satellites, status, transmit, track TARGET, antennas, antenna NAME, simulate FAULT, "
              "console LINE, console-lines, protocol-log-on, protocol-log-off, protocol-lines NUMBER and the commands "
              "of the schedule.\n");
    EXPECT_EQ(ask(QByteArray(100000, 'x')), "error: The line is longer than 4352 bytes.\n");
    EXPECT_EQ(ask("stop" + QByteArray(kLongestLine - 3, ' ') + "\n"), "error: The line is longer than 4352 bytes.\n");
    EXPECT_THAT(asked, IsEmpty());
    agreement = QByteArray();
    EXPECT_EQ(ask("stop" + QByteArray(kLongestLine - 4, ' ') + "\n"), "ok\n");
}

// REQ-LOCALSOCKET-02
TEST_F(LocalServerTest, ALineMayComeInPieces)
{
    ASSERT_TRUE(listen());
    const auto slow = client(1);
    slow->write("reset");
    slow->flush();
    EXPECT_EQ(ask("take\n"), "ok\n") << "the other waits for nobody";
    EXPECT_EQ(answerTo(*slow, "-stop\n"), "ok\n");
    EXPECT_THAT(asked, ElementsAre(LocalCommand::Take, LocalCommand::ResetStop));
}

// REQ-LOCALSOCKET-941: An answer of many lines arrives complete, even if it is more than the socket accepts at once.
TEST_F(LocalServerTest, ALongAnswerArrivesWhole)
{
    ASSERT_TRUE(listen());
    agreement = QByteArray(kMany, 'x') + '\n';
    const std::string answer = ask("satellites\n");
    EXPECT_EQ(answer.size(), static_cast<std::size_t>(kMany) + 4);
    EXPECT_TRUE(answer.starts_with("ok\nxxx"));
    EXPECT_TRUE(answer.ends_with("x\n"));
}

// REQ-LOCALSOCKET-941
TEST_F(LocalServerTest, AClientThatReadsSlowlyHasTime)
{
    ASSERT_TRUE(listen());
    agreement = QByteArray(kMany, 'x') + '\n';
    const FileDescriptor slow(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
    ASSERT_EQ(withAddress(::connect, slow), 0);
    ASSERT_EQ(::send(slow.number(), "satellites\n", 11, MSG_NOSIGNAL), 11);
    qsizetype received = 0;
    std::vector<char> part(200'000);
    for (ssize_t size = 1; size > 0; received += size) {
        QCoreApplication::processEvents();  // the server sends more
        timers.elapse(Seconds(1.9));
        ASSERT_TRUE(waitUntil([&] {
            size = ::recv(slow.number(), part.data(), part.size(), MSG_DONTWAIT);
            return size >= 0;
        }));
    }
    EXPECT_EQ(received, kMany + 4);
}

// REQ-LOCALSOCKET-942: The station may answer at any later time. The client waits, and other clients are answered
// meanwhile. A client that has disconnected receives nothing.
TEST_F(LocalServerTest, TheStationMayAnswerLater)
{
    ASSERT_TRUE(listen());
    answersLater = true;
    const auto patient = client(1);
    patient->write("track table /tmp/a.txt\n");
    ASSERT_TRUE(waitUntil([this] { return asked.size() == 1; }));
    timers.elapse(Seconds(60.0));
    const Reply reply = later;
    answersLater = false;
    EXPECT_EQ(ask("take\n"), "ok\n");
    reply(QByteArray("a.txt\n"));
    EXPECT_EQ(answerTo(*patient, {}), "ok\na.txt\n");

    answersLater = true;
    const auto gone = client(1);
    gone->write("track moon\n");
    ASSERT_TRUE(waitUntil([this] { return asked.size() == 3; }));
    gone->abort();
    ASSERT_TRUE(waitUntil([this] { return server.findChildren<LocalConversation*>().isEmpty(); }));
    later(QByteArray("Moon\n"));
}

// REQ-LOCALSOCKET-03: At most eight clients at the same time. One that sends no command within 2 s is closed.
TEST_F(LocalServerTest, TheNinthIsSentAwayUntilTheSilentOnesAreClosed)
{
    ASSERT_TRUE(listen());
    std::vector<std::unique_ptr<QLocalSocket>> silent;
    for (int i = 1; i <= LocalServer::kMostClients; ++i) {
        silent.push_back(client(i));
    }
    EXPECT_THAT(ask({}), StartsWith("error: Too many programs ask"));
    timers.elapse(Seconds(1.9));
    EXPECT_THAT(ask({}), StartsWith("error: Too many programs ask"));
    timers.elapse(Seconds(0.1));
    for (const auto& one : silent) {
        EXPECT_EQ(answerTo(*one, {}), "error: No command came within 2 s.\n");
    }
    EXPECT_EQ(ask("take\n"), "ok\n");
    EXPECT_THAT(asked, ElementsAre(LocalCommand::Take));
}

// Story: the ninth client was closed while its line was still on the way, so it saw a broken pipe instead of the
// reason.
// REQ-LOCALSOCKET-931: The answer reaches a client that is still sending.
TEST_F(LocalServerTest, TheNinthReadsItsAnswerAlthoughItStillSends)
{
    ASSERT_TRUE(listen());
    std::vector<std::unique_ptr<QLocalSocket>> silent;
    for (int i = 1; i <= LocalServer::kMostClients; ++i) {
        silent.push_back(client(i));
    }
    const FileDescriptor ninth(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
    ASSERT_EQ(withAddress(::connect, ninth), 0);
    const auto isAnswered = [this] {
        return std::ranges::any_of(server.findChildren<LocalConversation*>(), &LocalConversation::isOver);
    };
    ASSERT_TRUE(waitUntil(isAnswered));
    EXPECT_EQ(::send(ninth.number(), "take\n", 5, MSG_NOSIGNAL), 5);
    std::array<char, kRoom> answer{};
    const auto size = ::recv(ninth.number(), answer.data(), answer.size(), 0);
    ASSERT_GT(size, 0);
    EXPECT_THAT(std::string(answer.data(), static_cast<std::size_t>(size)), StartsWith("error: Too many programs"));
    EXPECT_THAT(asked, IsEmpty());
}

// REQ-LOCALSOCKET-03
TEST_F(LocalServerTest, WhoLeavesMakesRoom)
{
    ASSERT_TRUE(listen());
    for (int i = 0; i < 3 * LocalServer::kMostClients; ++i) {
        const auto one = client(1);
        one->write("sto");
        one->disconnectFromServer();
        EXPECT_TRUE(waitUntil([this] { return server.findChildren<LocalConversation*>().isEmpty(); }));
    }
    EXPECT_THAT(asked, IsEmpty());
}

// REQ-LOCALSOCKET-04: Only the user of the station can open the folder and the socket, whatever permissions the folder
// had before. A folder that is a symbolic link is refused.
TEST_F(LocalServerTest, OnlyItsUserComesIn)
{
    const QString folder = runtime.filePath(QStringLiteral("boresight"));
    ASSERT_TRUE(QDir().mkdir(folder));
    ASSERT_EQ(::chmod(QFile::encodeName(folder).constData(), 0777), 0);
    ASSERT_TRUE(listen());
    EXPECT_EQ(server.path(), path);
    EXPECT_EQ(rightsOf(folder), 0700U);
    EXPECT_EQ(rightsOf(path) & 0077U, 0U);
    server.close();
    EXPECT_FALSE(QFile::exists(path));
    ASSERT_TRUE(QDir().rmdir(folder));
    ASSERT_TRUE(QFile::link(runtime.path(), folder));
    const auto linked = listen();
    ASSERT_FALSE(linked);
    EXPECT_EQ(linked.error().code, ErrorCode::Denied);
}

// REQ-LOCALSOCKET-05: The socket of a program that was killed is removed. If another program listens on the socket, it
// is left alone, and the refusal names it. Without XDG_RUNTIME_DIR there is no local socket.
TEST_F(LocalServerTest, WhatAKilledProgramLeftIsRemoved)
{
    leaveASocket();
    ASSERT_TRUE(listen());
    EXPECT_EQ(ask("take\n"), "ok\n");
    LocalServer second([](const LocalRequest&, const Reply& reply) { reply(LocalAnswer()); });
    const auto other = second.listen(runtime.path(), kPort);
    ASSERT_FALSE(other);
    EXPECT_EQ(other.error().code, ErrorCode::Busy);
    EXPECT_THAT(other.error().text.toStdString(), HasSubstr(path.toStdString()));
    second.close();
    EXPECT_EQ(ask("take\n"), "ok\n") << "the first goes on";
}

// REQ-LOCALSOCKET-05
TEST_F(LocalServerTest, NeedsAFolderOfTheUser)
{
    EXPECT_EQ(server.listen({}, kPort).error().text, QStringLiteral("XDG_RUNTIME_DIR is not set"));
    EXPECT_FALSE(server.listen(runtime.filePath(QStringLiteral("nowhere")), kPort));
    EXPECT_TRUE(server.path().isEmpty());
}

// REQ-LOCALSOCKET-06: A client that is connected while the station closes receives an answer about this.
TEST_F(LocalServerTest, TheEndOfTheStationIsAnAnswer)
{
    ASSERT_TRUE(listen());
    const auto waiting = client(1);
    server.close();
    EXPECT_EQ(answerTo(*waiting, {}), "error: The station is closing.\n");
}

}  // namespace
}  // namespace boresight::local
