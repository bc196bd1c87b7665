// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/can/fdcanusb_rig.h"
#include "tests/fakes/text_of.h"

#include <QFile>
#include <QTemporaryDir>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace boresight {
namespace {

using namespace std::chrono_literals;
using fakes::waitUntil;
using testing::HasSubstr;

// Story: the port name was mistyped, and 29 kB of frames in 4 s went into the control port of a radio. The frames did
// not stop.
class FdcanusbProbeTest : public testing::Test
{
protected:
    void openPort() { ASSERT_TRUE(link.open().has_value()); }
    void tick()
    {
        clock.advance(20ms);
        static_cast<void>(link.send(std::array{frameTo(0x8001, {0x50}), frameTo(0x8002, {0x50})}));
    }
    void run(std::chrono::milliseconds time)
    {
        for (auto left = time; left > 0ms; left -= 20ms) {
            tick();
        }
    }
    // Reopens the link once a second, as the station does with a lost link.
    void reopenFor(std::chrono::seconds time)
    {
        for (auto left = time; left > 0s; left -= 1s) {
            run(1s);
            if (link.status().state == LinkState::Lost) {
                static_cast<void>(link.open());
            }
        }
    }
    [[nodiscard]] bool framesArrive()
    {
        tick();
        return waitUntil([this] { return port.written.startsWith("can send 8001 50 BF\ncan send 8002 50 BF\n"); });
    }

    fakes::ManualClock clock;
    fakes::PseudoTerminal port;
    QTemporaryDir folder;
    FdcanusbLink link{port.path(), clock};
};

// REQ-CAN-23 (FdcanusbProbeTest.*): If no adapter answers at a port, the port receives one query and nothing else. It
// is closed until the operator acts or another device takes its place. A stall of this computer does not count as
// silence.
TEST_F(FdcanusbProbeTest, SilentPortHearsOneQuestionAndNothingElse)
{
    openPort();
    reopenFor(60s);
    ASSERT_TRUE(waitUntil([this] { return port.written == fakes::kProbe; })) << port.written.toStdString();
    EXPECT_EQ(link.status().state, LinkState::Lost);
    EXPECT_TRUE(link.status().leftAlone);
    EXPECT_EQ(link.status().sent, 0U);
    EXPECT_THAT(link.status().text.toStdString(), HasSubstr("no fdcanusb answers on this port"));
    EXPECT_EQ(textOf(link.open().error()), link.status().text.toStdString());
    EXPECT_EQ(port.written, fakes::kProbe);
}

TEST_F(FdcanusbProbeTest, AnotherDeviceThatTalksIsNoAdapterEither)
{
    openPort();
    port.write("ID019;?;\r\n$GNGGA,,,,*56\r\ncan status\r\nERROR\r\n");
    ASSERT_TRUE(waitUntil([this] { return link.status().dropped == 4; }));
    reopenFor(10s);
    EXPECT_TRUE(link.status().leftAlone);
    EXPECT_TRUE(waitUntil([this] { return port.written == fakes::kProbe; })) << port.written.toStdString();
}

// Nobody sends while the station is closing, and the port must be free for its own program.
TEST_F(FdcanusbProbeTest, SilentPortIsGivenBackWithoutAnySend)
{
    openPort();
    clock.advance(FdcanusbLink::kProbeTime);
    ASSERT_TRUE(waitUntil([this] { return link.status().state == LinkState::Lost; }));
    FdcanusbLink other{port.path(), clock};
    EXPECT_TRUE(other.open().has_value());
}

TEST_F(FdcanusbProbeTest, OperatorAsksAgain)
{
    openPort();
    ASSERT_TRUE(waitUntil([this] { return port.written == fakes::kProbe; }));
    port.takeWritten();
    reopenFor(3s);
    ASSERT_TRUE(link.status().leftAlone);
    link.close();
    openPort();
    fakes::answerProbe(port, link);
    EXPECT_TRUE(framesArrive());
}

TEST_F(FdcanusbProbeTest, AdapterWithoutDrivesIsFedAtOnce)
{
    openPort();
    fakes::answerProbe(port, link);
    EXPECT_TRUE(framesArrive());
    EXPECT_EQ(link.status().state, LinkState::Up);
}

TEST_F(FdcanusbProbeTest, EveryKindOfAnswerProvesTheAdapter)
{
    for (const char* const answer : {"OK\r\n", "ERR unknown subcommand\r\n", "rcv 0100 21 e B F r x-1\r\n"}) {
        fakes::PseudoTerminal another;
        FdcanusbLink one{another.path(), clock};
        ASSERT_TRUE(one.open().has_value());
        ASSERT_TRUE(waitUntil([&] { return another.written == fakes::kProbe; }));
        another.takeWritten();
        another.write(answer);
        ASSERT_TRUE(waitUntil([&] {
            static_cast<void>(one.send(std::array{frameTo(0x8001, {0x50})}));
            return another.written.startsWith("can send 8001");
        })) << answer;
        EXPECT_EQ(one.status().text, QString()) << answer;
    }
}

// The right adapter is plugged in under the name of the wrong port.
TEST_F(FdcanusbProbeTest, AnotherDeviceInItsPlaceIsAskedByItself)
{
    const QString name = folder.filePath(QStringLiteral("adapter"));
    const fakes::PseudoTerminal radio;
    ASSERT_TRUE(QFile::link(radio.path(), name));
    FdcanusbLink named{name, clock};
    ASSERT_TRUE(named.open().has_value());
    clock.advance(FdcanusbLink::kProbeTime);
    ASSERT_FALSE(named.send(std::array{frameTo(0x8001, {0x50})}).has_value());
    ASSERT_FALSE(named.open().has_value());
    QFile::remove(name);
    ASSERT_TRUE(QFile::link(port.path(), name));
    ASSERT_TRUE(named.open().has_value());
    fakes::answerProbe(port, named);
    EXPECT_TRUE(named.send(std::array{frameTo(0x8001, {0x50})}).has_value());
}

// The answer is ready to be read when this computer wakes up.
TEST_F(FdcanusbProbeTest, StallOfThisComputerIsNoSilenceOfTheAdapter)
{
    openPort();
    ASSERT_TRUE(waitUntil([this] { return port.written == fakes::kProbe; }));
    port.takeWritten();
    port.write("lec=0 dlec=0 err=0 warn=0 busoff=0\r\n");
    pollfd arrived{.fd = ::open(port.path().toLocal8Bit().constData(), O_RDONLY | O_NOCTTY | O_CLOEXEC),
                   .events = POLLIN,
                   .revents = 0};
    ASSERT_EQ(poll(&arrived, 1, 60'000), 1);
    ::close(arrived.fd);
    clock.advance(5s);
    tick();
    EXPECT_TRUE(waitUntil([this] {
        tick();
        return port.written.startsWith("can send");
    }));
}

}  // namespace
}  // namespace boresight
