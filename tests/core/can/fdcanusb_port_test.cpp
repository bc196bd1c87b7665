// SPDX-License-Identifier: GPL-3.0-or-later
// The port of the adapter: unplugged, in use, locked, without permission.
#include "tests/core/can/fdcanusb_rig.h"
#include "tests/fakes/text_of.h"

#include <QCoreApplication>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

namespace boresight {
namespace {

using namespace std::chrono_literals;
using fakes::waitUntil;
using testing::HasSubstr;

// REQ-CAN-09: Unplugging is detected at once. A program that was killed does not keep the port.
TEST_F(FdcanusbLinkTest, UnpluggedAdapterIsLostAtOnceAndOpensAgain)
{
    adapter.unplug();
    ASSERT_TRUE(waitUntil([this] { return link.status().state == LinkState::Lost; })) << "without a frame to send";
    EXPECT_THAT(text(), HasSubstr("the adapter is gone. Plug it in again"));
    const auto sent = link.send(std::array{frameTo(0x8001, {0x50})});
    ASSERT_FALSE(sent.has_value());
    EXPECT_EQ(textOf(sent.error()), text());
    ASSERT_FALSE(link.open().has_value());

    const QTemporaryDir folder;
    const fakes::PseudoTerminal other;
    ASSERT_TRUE(QFile::link(other.path(), folder.filePath(QStringLiteral("adapter"))));
    FdcanusbLink linkByAlias{folder.filePath(QStringLiteral("adapter")), clock};
    open(linkByAlias);
    EXPECT_EQ(linkByAlias.status().state, LinkState::Up);
}

TEST_F(FdcanusbLinkTest, AdapterGoneBetweenTwoSendsIsLost)
{
    sendOne();
    adapter.unplug();
    static_cast<void>(link.send(std::array{frameTo(0x8001, {0x50})}));
    ASSERT_TRUE(waitUntil([this] { return link.status().state == LinkState::Lost; }));
}

// Neither the lock file of a killed program nor the kernel's exclusive flag prevents the next program from opening the
// port.
// REQ-CAN-09
TEST_F(FdcanusbLinkTest, PortOfAKilledProgramOpensAgain)
{
    link.close();
    const pid_t child = fork();
    if (child == 0) {
        const bool opened = link.open().has_value();
        raise(opened ? SIGKILL : SIGTERM);
    }
    int how = 0;
    ASSERT_EQ(waitpid(child, &how, 0), child);
    ASSERT_TRUE(WIFSIGNALED(how) && WTERMSIG(how) == SIGKILL);
    open(link);
}

TEST_F(FdcanusbLinkTest, ReopenForgetsHalfLinesAndUnconfirmedFrames)
{
    sendOne();
    adapter.write("rcv 0100 2100");
    ASSERT_TRUE(written("can send 8001 50 BF\n"));
    adapter.takeWritten();
    open(link);
    fakes::answerProbe(adapter, link);
    adapter.write("rcv 0200 21000A e B F r x-1\n");
    ASSERT_TRUE(waitUntil([this] { return frames.size() == 1; }));
    EXPECT_EQ(received(0).id, 0x200U);
    clock.advance(100ms);
    sendOne();
    EXPECT_EQ(link.status().busErrors, 0U);
}

TEST_F(FdcanusbLinkTest, OpenErrorsNameTheRemedy)
{
    FdcanusbLink second{adapter.path(), clock};
    const auto busy = second.open();
    ASSERT_FALSE(busy.has_value());
    EXPECT_EQ(busy.error().code, ErrorCode::Busy);
    EXPECT_THAT(textOf(busy.error()), HasSubstr("in use by another program"));

    FdcanusbLink absent{QStringLiteral("/dev/boresight/absent"), clock};
    EXPECT_EQ(absent.open().error().code, ErrorCode::NoDevice);
    EXPECT_THAT(textOf(absent.open().error()), HasSubstr("Plug the adapter in"));

    FdcanusbLink file{QCoreApplication::applicationFilePath(), clock};
    EXPECT_THAT(textOf(file.open().error()), HasSubstr("not a serial port"));
}

// The tools of the maker take no lock. The kernel shows which program has the port open.
// REQ-CAN-19: A port that another program of any user has open or locked is not shared, and that program is named. On a
// real port the kernel's exclusive flag stays set.
TEST_F(FdcanusbLinkTest, PortInUseNamesTheProgramThatHoldsIt)
{
    link.close();
    QProcess tool;
    tool.setStandardInputFile(adapter.path());
    tool.start(QStringLiteral("sleep"), {QStringLiteral("60")});
    ASSERT_TRUE(waitUntil([&tool] { return tool.state() == QProcess::Running; }));
    const auto busy = link.open();
    tool.kill();
    ASSERT_FALSE(busy.has_value());
    EXPECT_EQ(busy.error().code, ErrorCode::Busy);
    EXPECT_EQ(textOf(busy.error()), adapter.path().toStdString() + " is in use by sleep (process " +
                                        std::to_string(tool.processId()) + "). End that program first");
    ASSERT_TRUE(waitUntil([&tool] { return tool.state() == QProcess::NotRunning; }));
    open(link);
}

// Story: a second program of another user took the adapter of the running service. It can see neither the open files of
// the service nor the folder of its lock file. In this test this program itself holds the port, and the search in /proc
// skips it.
// REQ-CAN-19
TEST_F(FdcanusbLinkTest, PortThatIsLockedInAnyWayIsRefused)
{
    link.close();
    const FileDescriptor holder(::open(adapter.path().toLocal8Bit().constData(), O_RDWR | O_NOCTTY | O_CLOEXEC));
    ASSERT_EQ(flock(holder.number(), LOCK_EX | LOCK_NB), 0);
    const auto busy = link.open();
    ASSERT_FALSE(busy.has_value());
    EXPECT_EQ(busy.error().code, ErrorCode::Busy);
    EXPECT_EQ(textOf(busy.error()), adapter.path().toStdString() + " is in use by " + program_invocation_short_name +
                                        " (process " + std::to_string(getpid()) + "). End that program first");
    EXPECT_EQ(adapter.written, QByteArray());
    ASSERT_EQ(flock(holder.number(), LOCK_UN), 0);
    open(link);
}

// REQ-CAN-19
TEST_F(FdcanusbLinkTest, OpenPortIsLockedForOthersUntilItIsClosed)
{
    const FileDescriptor other(::open(adapter.path().toLocal8Bit().constData(), O_RDWR | O_NOCTTY | O_CLOEXEC));
    EXPECT_EQ(flock(other.number(), LOCK_EX | LOCK_NB), -1);
    link.close();
    EXPECT_EQ(flock(other.number(), LOCK_EX | LOCK_NB), 0);
}

// The kernel's exclusive flag stays set on real ports: those of USB adapters (166, 188) and of the board (4).
// REQ-CAN-19 (SerialPortCheck.*)
TEST(SerialPortCheck, OnlyAPseudoTerminalIsOne)
{
    EXPECT_FALSE(isPseudoTerminal(makedev(166, 0)));
    EXPECT_FALSE(isPseudoTerminal(makedev(188, 0)));
    EXPECT_FALSE(isPseudoTerminal(makedev(4, 64)));
    EXPECT_TRUE(isPseudoTerminal(makedev(136, 0)));
    EXPECT_TRUE(isPseudoTerminal(makedev(143, 255)));
    const fakes::PseudoTerminal terminal;
    const FileDescriptor end(::open(terminal.path().toLocal8Bit().constData(), O_RDWR | O_NOCTTY | O_CLOEXEC));
    EXPECT_TRUE(isPseudoTerminal(end.number()));
}

// REQ-CAN-13
TEST_F(FdcanusbLinkTest, MissingPermissionNamesTheUdevRule)
{
    link.close();
    ASSERT_EQ(chmod(adapter.path().toLocal8Bit().constData(), 0), 0);
    const bool root = geteuid() == 0;
    constexpr uid_t kNobody = 65534;
    ASSERT_TRUE(!root || seteuid(kNobody) == 0);  // root may open everything
    const auto result = link.open();
    ASSERT_TRUE(!root || seteuid(0) == 0);
    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(result.error().code, ErrorCode::Denied);
    EXPECT_THAT(textOf(result.error()), HasSubstr("70-boresight-fdcanusb.rules"));
    EXPECT_THAT(textOf(result.error()), HasSubstr("group dialout"));
}

}  // namespace
}  // namespace boresight
