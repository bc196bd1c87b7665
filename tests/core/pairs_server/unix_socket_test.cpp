// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file_descriptor.h"
#include "core/pairs_server/pairs_talk.h"
#include "core/rotctld/server.h"
#include "tests/fakes/dummy_rotator.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/wait_until.h"

#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <string>

namespace boresight::pairs {
namespace {

sockaddr_un addressOf(const std::string& path)
{
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::ranges::copy(path, std::begin(address.sun_path));
    return address;
}

FileDescriptor newSocket()
{
    return FileDescriptor(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
}

class Program
{
public:
    explicit Program(const std::string& path) : m_socket(newSocket())
    {
        const sockaddr_un address = addressOf(path);
        const void* const untyped = &address;
        m_isConnected = ::connect(m_socket.number(), static_cast<const sockaddr*>(untyped), sizeof address) == 0;
    }
    [[nodiscard]] bool isConnected() const { return m_isConnected; }
    [[nodiscard]] std::string ask(std::string_view line) const
    {
        EXPECT_EQ(::send(m_socket.number(), line.data(), line.size(), MSG_NOSIGNAL), static_cast<ssize_t>(line.size()));
        return answer();
    }
    // Reads one line.
    [[nodiscard]] std::string answer() const
    {
        std::string text;
        EXPECT_TRUE(fakes::waitUntil([&] {
            std::array<char, 256> buffer{};
            const ssize_t count = ::recv(m_socket.number(), buffer.data(), buffer.size(), MSG_DONTWAIT);
            text.append(buffer.data(), count > 0 ? static_cast<std::size_t>(count) : 0U);
            return text.ends_with('\n');
        })) << text;
        return text;
    }
    // As "echo 60 | nc -U" does.
    void endSending() const { ::shutdown(m_socket.number(), SHUT_WR); }

private:
    FileDescriptor m_socket;
    bool m_isConnected = false;
};

struct UnixSocket : ::testing::Test
{
    [[nodiscard]] std::unique_ptr<rotctld::Server> serve()
    {
        return std::make_unique<rotctld::Server>(rotctld::ServerSettings{.unixPath = path, .protocol = "Pairs"},
                                                 talkPairs(rotator, clock, [] { return std::nullopt; }), rotator,
                                                 clock);
    }
    [[nodiscard]] bool isThere() const
    {
        struct stat found
        {};
        return ::lstat(path.c_str(), &found) == 0;
    }

    QTemporaryDir folder;
    std::string path = folder.filePath(QStringLiteral("pairs")).toStdString();
    fakes::ManualClock clock;
    fakes::DummyRotator rotator{clock};
};

// REQ-LISTENERS-08 (UnixSocket.*): A socket in the file system is served like a port. Only programs of the station's
// user can open it. It is removed at the end. The socket of a program that was killed is replaced.
TEST_F(UnixSocket, ServesSeveralPrograms)
{
    const auto server = serve();
    ASSERT_TRUE(server->listen());
    EXPECT_EQ(server->address(), path);
    const Program first(path);
    const Program second(path);
    EXPECT_EQ(first.ask("10 20\n"), "OK\n");
    EXPECT_EQ(second.ask("?\n"), "0.0 0.0\n");
    const auto clients = server->clients();
    ASSERT_EQ(clients.size(), 2U);
    EXPECT_EQ(clients[0].address, path + ":" + std::to_string(::getpid()));
    EXPECT_EQ(clients[0].program, "Pairs");
    EXPECT_EQ(clients[0].lastCommand, QStringLiteral("10 20"));
}

TEST_F(UnixSocket, AnswersWhoHasSentAll)
{
    const auto server = serve();
    ASSERT_TRUE(server->listen());
    const Program program(path);
    program.endSending();
    EXPECT_TRUE(fakes::waitUntil([&] { return !rotator.gone.empty(); }));
    const Program other(path);
    EXPECT_EQ(other.ask("60\n"), "OK\n");
    other.endSending();
    EXPECT_TRUE(fakes::waitUntil([&] { return rotator.gone.size() == 2; }));
}

TEST_F(UnixSocket, IsOfTheUserAlone)
{
    const mode_t before = ::umask(0);
    const auto server = serve();
    const Result<> listening = server->listen();
    ::umask(before);
    ASSERT_TRUE(listening);
    struct stat found
    {};
    ASSERT_EQ(::stat(path.c_str(), &found), 0);
    EXPECT_EQ(found.st_mode & 0777U, 0600U);
    EXPECT_TRUE(S_ISSOCK(found.st_mode));
}

TEST_F(UnixSocket, IsRemovedAtTheEnd)
{
    {
        const auto server = serve();
        ASSERT_TRUE(server->listen());
        EXPECT_TRUE(isThere());
    }
    EXPECT_FALSE(isThere());
}

TEST_F(UnixSocket, ThatWasLeftBehindIsReplaced)
{
    {
        const FileDescriptor killed = newSocket();
        const sockaddr_un address = addressOf(path);
        const void* const untyped = &address;
        ASSERT_EQ(::bind(killed.number(), static_cast<const sockaddr*>(untyped), sizeof address), 0);
    }
    ASSERT_TRUE(isThere());
    const auto server = serve();
    ASSERT_TRUE(server->listen());
    EXPECT_EQ(Program(path).ask("?\n"), "0.0 0.0\n");
}

// REQ-LISTENERS-03
TEST_F(UnixSocket, ThatIsServedIsAnError)
{
    const auto server = serve();
    ASSERT_TRUE(server->listen());
    const auto second = serve();
    const Result<> refused = second->listen();
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Busy);
    EXPECT_TRUE(refused.error().text.contains(QString::fromStdString(path)));
    EXPECT_EQ(Program(path).ask("?\n"), "0.0 0.0\n") << "the first serves on";
}

TEST_F(UnixSocket, OfAnotherProgramIsLeftAlone)
{
    const FileDescriptor other = newSocket();
    const sockaddr_un address = addressOf(path);
    const void* const untyped = &address;
    ASSERT_EQ(::bind(other.number(), static_cast<const sockaddr*>(untyped), sizeof address), 0);
    ASSERT_EQ(::listen(other.number(), 1), 0);
    const Result<> refused = serve()->listen();
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Busy);
    EXPECT_TRUE(Program(path).isConnected());
}

TEST_F(UnixSocket, AFileOfSomebodyElseIsLeftAlone)
{
    QFile file(QString::fromStdString(path));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    ASSERT_EQ(file.write("mine"), 4);
    file.close();
    EXPECT_FALSE(serve()->listen());
    EXPECT_EQ(QFileInfo(file).size(), 4);
}

TEST_F(UnixSocket, APlaceThatCannotBeIsAnError)
{
    path = folder.filePath(QStringLiteral("missing/pairs")).toStdString();
    const Result<> nowhere = serve()->listen();
    ASSERT_FALSE(nowhere);
    EXPECT_TRUE(nowhere.error().text.contains(QStringLiteral("folder")));
    path = "/" + std::string(120, 'x');
    const Result<> tooLong = serve()->listen();
    ASSERT_FALSE(tooLong);
    EXPECT_EQ(tooLong.error().code, ErrorCode::InvalidInput);
}

}  // namespace
}  // namespace boresight::pairs
