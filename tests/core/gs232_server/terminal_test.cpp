// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file_descriptor.h"
#include "core/gs232_server/emulated_box.h"
#include "core/rotctld/server.h"
#include "tests/fakes/dummy_rotator.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/wait_until.h"

#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <string>

namespace boresight::gs232 {
namespace {

using namespace std::chrono_literals;

// A program with the terminal open, as Hamlib opens a serial port.
class SerialProgram
{
public:
    explicit SerialProgram(const std::string& path) : m_line(::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK)) {}
    [[nodiscard]] bool isOpen() const { return m_line.number() >= 0; }
    void say(std::string_view bytes) const
    {
        EXPECT_EQ(::write(m_line.number(), bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
    }
    [[nodiscard]] std::string answer(std::size_t size)
    {
        std::string text;
        EXPECT_TRUE(fakes::waitUntil([&] {
            text += heard();
            return text.size() >= size;
        })) << text;
        return text;
    }
    [[nodiscard]] std::string heard() const
    {
        std::array<char, 256> buffer{};
        const ssize_t count = ::read(m_line.number(), buffer.data(), buffer.size());
        return count > 0 ? std::string(buffer.data(), static_cast<std::size_t>(count)) : std::string();
    }
    // Whether the server has closed the connection.
    [[nodiscard]] bool isCut() const
    {
        char one = 0;
        return ::read(m_line.number(), &one, 1) == 0;
    }

private:
    FileDescriptor m_line;
};

struct Terminal : ::testing::Test
{
    [[nodiscard]] std::unique_ptr<rotctld::Server> serve()
    {
        return std::make_unique<rotctld::Server>(rotctld::ServerSettings{.pty = path, .protocol = "GS-232B"},
                                                 talkGs232(rotator, clock, Dialect::B), rotator, clock);
    }
    [[nodiscard]] bool untilGone(std::size_t count)
    {
        return fakes::waitUntil([&] { return rotator.gone.size() == count; });
    }

    QTemporaryDir folder;
    std::string path = (folder.path() + QStringLiteral("/rotator")).toStdString();
    fakes::ManualClock clock;
    fakes::DummyRotator rotator{clock};
};

// REQ-LISTENERS-02 (Terminal.*): A pseudo-terminal is served like a port. A program opens the link like a serial port,
// and is a client while it has it open. The link stays valid when programs connect, leave or are disconnected.
TEST_F(Terminal, IsASerialPortToAProgram)
{
    const auto server = serve();
    ASSERT_TRUE(server->listen());
    EXPECT_EQ(server->address(), path);
    for (std::size_t round = 1; round <= 3; ++round) {
        {
            SerialProgram program(path);
            ASSERT_TRUE(program.isOpen());
            program.say("C2\r");
            EXPECT_EQ(program.answer(16), "AZ=000  EL=000\r\n");
            ASSERT_EQ(server->clients().size(), 1U);
            EXPECT_EQ(server->clients().front().address, path);
        }
        EXPECT_TRUE(untilGone(round));
        EXPECT_TRUE(server->clients().empty());
    }
}

TEST_F(Terminal, AClientThatVanishesEndsItsTurning)
{
    const auto server = serve();
    ASSERT_TRUE(server->listen());
    {
        SerialProgram program(path);
        program.say("R\r");
        EXPECT_EQ(program.answer(1), "\r");
        EXPECT_NE(rotator.mover, 0U);
    }
    EXPECT_TRUE(untilGone(1));
    EXPECT_EQ(rotator.mover, 0U);
}

// As "printf 'S\r' > /tmp/rotator" in a shell.
TEST_F(Terminal, WhatAProgramWroteBeforeItLeftCounts)
{
    const auto server = serve();
    ASSERT_TRUE(server->listen());
    SerialProgram(path).say("W060 030\r");
    EXPECT_TRUE(untilGone(1));
    ASSERT_TRUE(rotator.lastRequest);
    EXPECT_EQ(rotator.lastRequest->azimuth, 60_deg);
    SerialProgram next(path);
    next.say("C\r");
    EXPECT_EQ(next.answer(8), "AZ=000\r\n") << "without the answer to the last program";
}

TEST_F(Terminal, WhoIsHungUpOnLosesTheLineAndMayComeAgain)
{
    const auto server = serve();
    ASSERT_TRUE(server->listen());
    SerialProgram program(path);
    program.say("C\r");
    EXPECT_EQ(program.answer(8), "AZ=000\r\n");
    ASSERT_TRUE(server->disconnect(server->clients().front().id, QStringLiteral("by the operator")));
    clock.advance(3s);
    EXPECT_TRUE(fakes::waitUntil([&] { return program.isCut(); }));
    SerialProgram again(path);
    again.say("C\r");
    EXPECT_EQ(again.answer(8), "AZ=000\r\n");
}

// REQ-LISTENERS-03: If the place is already in use, this is an error with its reason, and nothing that belongs to
// others is overwritten.
TEST_F(Terminal, APlaceThatIsTakenIsAnError)
{
    const auto first = serve();
    ASSERT_TRUE(first->listen());
    const auto second = serve();
    const auto refused = second->listen();
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Busy);
    EXPECT_TRUE(refused.error().text.contains(QString::fromStdString(path)));
    SerialProgram program(path);
    program.say("C\r");
    EXPECT_EQ(program.answer(8), "AZ=000\r\n") << "the first serves on";
}

TEST_F(Terminal, AFileOfSomebodyElseIsLeftAlone)
{
    QFile file(QString::fromStdString(path));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    ASSERT_EQ(file.write("mine"), 4);
    file.close();
    const auto server = serve();
    EXPECT_FALSE(server->listen());
    EXPECT_EQ(QFileInfo(file).size(), 4);
    path = (folder.path() + QStringLiteral("/missing/rotator")).toStdString();
    const auto nowhere = serve()->listen();
    ASSERT_FALSE(nowhere);
    EXPECT_TRUE(nowhere.error().text.contains(QStringLiteral("folder")));
}

TEST_F(Terminal, ALinkToSomethingElseIsLeftAlone)
{
    ASSERT_TRUE(QFile::link(folder.path(), QString::fromStdString(path)));
    EXPECT_FALSE(serve()->listen());
    EXPECT_EQ(QFileInfo(QString::fromStdString(path)).symLinkTarget(), folder.path());
}

// Anybody may create a pipe in /tmp, and opening it for reading blocks until somebody writes.
TEST_F(Terminal, APipeInPlaceOfTheLockHoldsUpNobody)
{
    ASSERT_EQ(::mkfifo((path + ".lock").c_str(), 0666), 0);
    const auto server = serve();
    EXPECT_TRUE(server->listen());
}

TEST_F(Terminal, ALinkThatWasLeftBehindIsReplacedAndItsOwnIsRemoved)
{
    ASSERT_TRUE(QFile::link(QStringLiteral("/dev/pts/no-longer"), QString::fromStdString(path)));
    {
        const auto server = serve();
        ASSERT_TRUE(server->listen());
        EXPECT_TRUE(SerialProgram(path).isOpen());
    }
    EXPECT_FALSE(QFileInfo(QString::fromStdString(path)).isSymLink());
}

}  // namespace
}  // namespace boresight::gs232
