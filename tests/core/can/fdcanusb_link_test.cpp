// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/can/fdcanusb_link.h"

#include "core/can/line_checksum.h"
#include "tests/core/can/adapter_probe.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/pseudo_terminal.h"
#include "tests/fakes/wait_until.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <poll.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>

namespace boresight {
namespace {

using namespace std::chrono_literals;
using fakes::waitUntil;
using testing::HasSubstr;

CanFrame frameTo(std::uint32_t id, std::initializer_list<std::uint8_t> bytes)
{
    CanFrame frame;
    frame.id = id;
    frame.extended = id > kMaxStandardId;
    frame.setPayload(std::vector<std::uint8_t>(bytes));
    return frame;
}

class FdcanusbLinkTest : public testing::Test
{
protected:
    FdcanusbLinkTest()
    {
        qRegisterMetaType<CanFrame>();
        qRegisterMetaType<LinkStatus>();
    }

    void SetUp() override
    {
        open(link);
        fakes::answerProbe(adapter, link);
        changes.clear();
    }
    static void open(FdcanusbLink& opened)
    {
        const auto result = opened.open();
        ASSERT_TRUE(result.has_value()) << result.error().text;
    }

    [[nodiscard]] CanFrame received(qsizetype index) const { return qvariant_cast<CanFrame>(frames.at(index).at(0)); }
    [[nodiscard]] std::string text() const { return link.status().text.toStdString(); }
    [[nodiscard]] bool written(const QByteArray& bytes) const
    {
        return waitUntil([this, &bytes] { return adapter.written == bytes; });
    }
    void sendOne() { ASSERT_TRUE(link.send(std::array{frameTo(0x8001, {0x50})}).has_value()); }

    fakes::ManualClock clock;
    fakes::PseudoTerminal adapter;
    FdcanusbLink link{adapter.path(), clock};
    QSignalSpy frames{&link, &CanLink::frameReceived};
    QSignalSpy changes{&link, &CanLink::statusChanged};
};

// REQ-CAN-05: Both axes' frames leave in one write. A batch that stops half-way reports how far it came.
TEST_F(FdcanusbLinkTest, BothAxesGoOutInOneWriteAndRepliesComeIn)
{
    ASSERT_TRUE(link.send(std::array{frameTo(0x8001, {0x11, 0x00}), frameTo(0x8002, {0x11, 0x00})}).has_value());
    ASSERT_TRUE(written("can send 8001 1100 BF\ncan send 8002 1100 BF\n"));
    clock.advance(1ms);
    adapter.write("OK\r\nrcv 0100 210000 e B F r x-1\r\nOK\r\nrcv 0200 21000A e B F r x-1\r\n");
    ASSERT_TRUE(waitUntil([this] { return frames.size() == 2; }));
    EXPECT_EQ(received(0), frameTo(0x100, {0x21, 0x00, 0x00}));
    EXPECT_EQ(received(1), frameTo(0x200, {0x21, 0x00, 0x0a}));
    EXPECT_EQ(received(0).received, clock.now());
    EXPECT_EQ(link.status(), (LinkStatus{.state = LinkState::Up, .text = {}, .sent = 2, .received = 2}));
}

TEST_F(FdcanusbLinkTest, HalfALineWaitsForItsRestWhereverItIsCut)
{
    const QByteArray line = "rcv 0100 210000 e B F r x-1\r\n";
    for (qsizetype cut = 0; cut < line.indexOf('\r'); ++cut) {
        frames.clear();
        adapter.write(line + line.left(cut));
        ASSERT_TRUE(waitUntil([this] { return frames.size() == 1; })) << "cut at " << cut;
        adapter.write(line.mid(cut));
        ASSERT_TRUE(waitUntil([this] { return frames.size() == 2; })) << "cut at " << cut;
        EXPECT_EQ(received(1), frameTo(0x100, {0x21, 0x00, 0x00}));
    }
    EXPECT_EQ(link.status().dropped, 0U);
}

// REQ-CAN-03
TEST_F(FdcanusbLinkTest, GarbageIsCountedAndNeverUsed)
{
    adapter.write("rcv 0100 21 e B F r x-1 *00\r\n\x01\xff\xfe nonsense\nrcv 0100 2\n" + QByteArray(1000, 'x') +
                  "\nrcv 0200 21000A e B F r x-1\n");
    ASSERT_TRUE(waitUntil([this] { return frames.size() == 1; }));
    EXPECT_EQ(received(0).id, 0x200U);
    EXPECT_EQ(link.status().dropped, 4U);
    EXPECT_EQ(link.status().state, LinkState::Up);
}

// REQ-CAN-06: An OK that does not come within 50 ms, and every ERR, is counted and reported until a frame is confirmed
// again.
TEST_F(FdcanusbLinkTest, MissingOkIsCountedAndSaidUntilTheNextOk)
{
    ASSERT_TRUE(link.send(std::array{frameTo(0x8001, {0x50}), frameTo(0x8002, {0x50})}).has_value());
    clock.advance(49ms);
    sendOne();
    EXPECT_EQ(link.status().busErrors, 0U);
    clock.advance(1ms);  // the first two are due; the timer notices by itself
    ASSERT_TRUE(waitUntil([this] { return link.status().busErrors == 2; }));
    EXPECT_THAT(text(), HasSubstr("no OK within 50 ms"));
    EXPECT_EQ(link.status().state, LinkState::Up);
    adapter.write("OK\n");
    ASSERT_TRUE(waitUntil([this] { return text().empty(); }));
    clock.advance(1s);
    sendOne();
    EXPECT_EQ(link.status().busErrors, 2U);  // the third was confirmed
}

// REQ-CAN-06
TEST_F(FdcanusbLinkTest, ErrIsShownWithTheAdaptersWords)
{
    sendOne();
    adapter.write("ERR invalid data\r\n");
    ASSERT_TRUE(waitUntil([this] { return !text().empty(); }));
    EXPECT_EQ(text(), link.name().toStdString() +
                          ": the adapter refuses a frame: invalid data; check its firmware and its can.* "
                          "settings");
    EXPECT_EQ(link.status().busErrors, 1U);
    EXPECT_EQ(link.status().state, LinkState::Up);
    clock.advance(1s);
    sendOne();
    EXPECT_EQ(link.status().busErrors, 1U);  // the ERR was the answer: nothing is missing
}

// Found by the fuzzer: a damaged refusal came onto the screen and into the log with its control characters.
TEST_F(FdcanusbLinkTest, ShowsADamagedRefusalPrintable)
{
    sendOne();
    adapter.write("ERR inv\x1b[2Jalid\x7f\r\n");
    ASSERT_TRUE(waitUntil([this] { return link.status().busErrors == 1; }));
    EXPECT_EQ(text(), link.name().toStdString() +
                          ": the adapter refuses a frame: inv?[2Jalid?; check its firmware and its can.* settings");
}

// REQ-CAN-07
TEST_F(FdcanusbLinkTest, AdapterOffTheBusIsDownAndIsSwitchedOn)
{
    sendOne();
    ASSERT_TRUE(written("can send 8001 50 BF\n"));
    adapter.takeWritten();
    adapter.write("ERR not in BusOn state\r\n");
    ASSERT_TRUE(waitUntil([this] { return link.status().state == LinkState::Down; }));
    EXPECT_THAT(text(), HasSubstr("not in BusOn state"));
    ASSERT_TRUE(written("can off\ncan on\n"));
    adapter.takeWritten();
    adapter.write("ERR already in BusOff\r\nOK\r\nend of answers\r\n");
    ASSERT_TRUE(waitUntil([this] { return link.status().dropped == 1; }));

    clock.advance(500ms);
    sendOne();  // refused again, but one restart a second is enough
    adapter.write("ERR not in BusOn state\r\n");
    ASSERT_TRUE(waitUntil([this] { return link.status().busErrors == 2; }));
    EXPECT_TRUE(written("can send 8001 50 BF\ncan status\n"));

    adapter.write("rcv 0100 210000 e B F r x-1\r\n");
    ASSERT_TRUE(waitUntil([this] { return link.status().state == LinkState::Up; }));
    EXPECT_EQ(text(), "");
}

// The firmware confirms frames with OK although its controller is bus-off: only "can status" tells. Asked after 200 ms
// of silence, so that it is on the screen within 300 ms.
// REQ-CAN-07: A silent adapter is asked for its bus status after 200 ms. Bus-off is reported, and restarted at most
// once a second.
TEST_F(FdcanusbLinkTest, SilentBusIsAskedForItsStatusAndRestarted)
{
    clock.advance(199ms);
    sendOne();
    ASSERT_TRUE(written("can send 8001 50 BF\n"));
    adapter.takeWritten();
    adapter.write("OK\r\n");
    clock.advance(1ms);
    sendOne();
    ASSERT_TRUE(written("can send 8001 50 BF\ncan status\n"));
    adapter.takeWritten();
    adapter.write("OK\r\nlec=3 dlec=7 err=1 warn=1 busoff=1 pexc=0 tdc=0\r\n");
    ASSERT_TRUE(waitUntil([this] { return link.status().state == LinkState::Down; }));
    EXPECT_THAT(text(), HasSubstr("bus-off after too many errors: check the cable, the 120 ohm"));
    EXPECT_TRUE(written("can off\ncan on\n"));
    adapter.takeWritten();
    adapter.write("OK\nOK\n");

    clock.advance(200ms);
    sendOne();
    ASSERT_TRUE(written("can send 8001 50 BF\ncan status\n"));
    adapter.write("OK\r\nlec=3 dlec=7 err=1 warn=1 busoff=0 pexc=0 tdc=0\r\n");
    ASSERT_TRUE(waitUntil([this] { return link.status().state == LinkState::Up; }));
    EXPECT_THAT(text(), HasSubstr("nobody acknowledges our frames: check the drives' power, the cable"));
    adapter.write("rcv 0100 210000 e B F r x-1\r\n");
    ASSERT_TRUE(waitUntil([this] { return text().empty(); }));
}

// Story: a bus-off adapter refuses frames too, and the two texts took turns in the log five times a second.
TEST_F(FdcanusbLinkTest, BusOffIsNotHiddenByTheRefusalsThatFollow)
{
    clock.advance(200ms);
    sendOne();
    adapter.write("OK\r\nlec=3 dlec=7 err=1 warn=1 busoff=1 pexc=0 tdc=0\r\n");
    ASSERT_TRUE(waitUntil([this] { return link.status().state == LinkState::Down; }));
    const QString told = link.status().text;
    EXPECT_THAT(text(), HasSubstr("bus-off after too many errors"));
    const std::uint64_t errors = link.status().busErrors;
    adapter.write("OK\r\nOK\r\n");  // to its restart
    sendOne();
    adapter.write("ERR not in BusOn state\r\n");
    ASSERT_TRUE(waitUntil([&] { return link.status().busErrors == errors + 1; }));
    EXPECT_EQ(link.status().text, told);
}

// Down for good: asked five times a second, restarted once.
// REQ-CAN-07
TEST_F(FdcanusbLinkTest, ControllerIsRestartedOnceASecond)
{
    int restarts = 0;
    for (int i = 0; i < 15; ++i) {
        clock.advance(200ms);
        sendOne();
        ASSERT_TRUE(waitUntil([this] { return adapter.written.contains("can status\n"); }));
        adapter.write("OK\nlec=3 dlec=7 err=1 warn=1 busoff=1 pexc=0 tdc=0\nrcv end\n");
        ASSERT_TRUE(waitUntil([this, i] { return link.status().dropped == static_cast<std::uint64_t>(i) + 1; }));
        sendOne();  // brings what was written before with it
        ASSERT_TRUE(waitUntil([this] { return adapter.written.count("can send") == 2; }));
        restarts += static_cast<int>(adapter.takeWritten().count("can off\ncan on\n"));
        adapter.write("OK\nOK\nOK\n");
    }
    EXPECT_EQ(restarts, 3);
    EXPECT_EQ(link.status().state, LinkState::Down);
}

TEST_F(FdcanusbLinkTest, AnsweringBusIsNotAsked)
{
    for (int i = 0; i < 3; ++i) {
        clock.advance(190ms);
        adapter.write("OK\nrcv 0100 210000 e B F r x-1\r\n");
        ASSERT_TRUE(waitUntil([this, i] { return frames.size() == i + 1; }));
        sendOne();
    }
    EXPECT_TRUE(written("can send 8001 50 BF\ncan send 8001 50 BF\ncan send 8001 50 BF\n"));
}

TEST_F(FdcanusbLinkTest, StatusThatIsNotKnownToTheAdapterIsNoTrouble)
{
    clock.advance(1s);
    sendOne();
    adapter.write("OK\nERR unknown subcommand\n");
    adapter.write("rcv 0100 210000 e B F r x-1\r\n");
    ASSERT_TRUE(waitUntil([this] { return frames.size() == 1; }));
    EXPECT_EQ(link.status().busErrors, 0U);
    EXPECT_EQ(text(), "");
}

// REQ-CAN-09: Unplugging is noticed at once. A killed program does not keep the port.
TEST_F(FdcanusbLinkTest, UnpluggedAdapterIsLostAtOnceAndOpensAgain)
{
    QElapsedTimer timer;
    timer.start();
    adapter.unplug();
    ASSERT_TRUE(waitUntil([this] { return link.status().state == LinkState::Lost; }));
    EXPECT_LT(timer.elapsed(), 250);
    EXPECT_THAT(text(), HasSubstr("the adapter is gone: plug it in again"));
    const auto sent = link.send(std::array{frameTo(0x8001, {0x50})});
    ASSERT_FALSE(sent.has_value());
    EXPECT_EQ(sent.error().text, text());
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

// Neither the lock file nor the kernel's exclusive mark of a killed program keeps the next one out.
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

TEST_F(FdcanusbLinkTest, ReceiverMayCloseTheLink)
{
    QObject::connect(&link, &CanLink::frameReceived, &link, &CanLink::close);
    adapter.write("rcv 0100 210000 e B F r x-1\nrcv 0200 210000 e B F r x-1\n");
    ASSERT_TRUE(waitUntil([this] { return link.status().state == LinkState::Closed; }));
    EXPECT_EQ(frames.size(), 1);
    EXPECT_FALSE(link.send(std::array{frameTo(0x8001, {0x50})}).has_value());
}

TEST_F(FdcanusbLinkTest, AdapterThatTakesNoDataIsReported)
{
    Result<> result;
    // Nobody reads the pseudo-terminal here: its buffer fills up, then ours.
    for (int i = 0; i < 10000 && result; ++i) {
        result = link.send(std::array{frameTo(0x8001, {0x50})});
    }
    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(result.error().code, ErrorCode::NoAnswer);
    EXPECT_THAT(result.error().text, HasSubstr("takes no more data"));
}

// REQ-CAN-04: An impossible frame is refused before any frame of its batch is sent.
TEST_F(FdcanusbLinkTest, ImpossibleFrameIsRefusedAndNothingOfTheBatchIsSent)
{
    const auto result = link.send(std::array{frameTo(0x8001, {0x50}), frameTo(0x2000'0000, {0x50})});
    EXPECT_EQ(result.error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(link.status().sent, 0U);
    sendOne();
    EXPECT_TRUE(written("can send 8001 50 BF\n"));
}

// REQ-CAN-08: Checksum mode adds checksums and takes no line without.
TEST_F(FdcanusbLinkTest, ChecksumModeAddsAndDemandsChecksums)
{
    link.close();
    FdcanusbLink uart{adapter.path(), clock, LineChecksum::On};
    open(uart);
    QSignalSpy uartFrames(&uart, &CanLink::frameReceived);
    ASSERT_TRUE(written(QByteArray::fromStdString(fdcanusb::withChecksum("can status")) + "\n"));
    adapter.takeWritten();
    adapter.write(QByteArray::fromStdString(fdcanusb::withChecksum("rcv 1E00 50")) + "\n");
    ASSERT_TRUE(waitUntil([&uartFrames] { return uartFrames.size() == 1; }));
    uartFrames.clear();
    ASSERT_TRUE(uart.send(std::array{frameTo(0x8001, {0x50})}).has_value());
    ASSERT_TRUE(written(QByteArray::fromStdString(fdcanusb::withChecksum("can send 8001 50 BF")) + "\n"));
    adapter.write("OK *BD\nrcv 0100 210000 e B F r x-1\nrcv 1E00 D8DE0CA303606A95393B5917 *6D\n");
    ASSERT_TRUE(waitUntil([&uartFrames] { return uartFrames.size() == 1; }));
    EXPECT_EQ(qvariant_cast<CanFrame>(uartFrames.at(0).at(0)).id, 0x1e00U);
    EXPECT_EQ(uart.status().dropped, 1U);
    EXPECT_EQ(uart.status().busErrors, 0U);
}

TEST_F(FdcanusbLinkTest, OpenErrorsNameTheRemedy)
{
    FdcanusbLink second{adapter.path(), clock};
    const auto busy = second.open();
    ASSERT_FALSE(busy.has_value());
    EXPECT_EQ(busy.error().code, ErrorCode::Busy);
    EXPECT_THAT(busy.error().text, HasSubstr("in use by another program"));

    FdcanusbLink absent{QStringLiteral("/dev/boresight/absent"), clock};
    EXPECT_EQ(absent.open().error().code, ErrorCode::NoDevice);
    EXPECT_THAT(absent.open().error().text, HasSubstr("plugged in"));

    FdcanusbLink file{QCoreApplication::applicationFilePath(), clock};
    EXPECT_THAT(file.open().error().text, HasSubstr("not a serial port"));
}

// The maker's tools take no lock: the kernel tells who has the port open.
// REQ-CAN-19: A port that another program of any user has open or locked is not shared: that program is named. The
// kernel's exclusive mark stays on a real port.
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
    EXPECT_EQ(busy.error().text, adapter.path().toStdString() + " is in use by sleep (process " +
                                     std::to_string(tool.processId()) + "): end it first");
    ASSERT_TRUE(waitUntil([&tool] { return tool.state() == QProcess::NotRunning; }));
    open(link);
}

// Story: 29 kB of frames in 4 s went into the control port of a radio behind a mistyped name, and no end of it.
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
    // As the station does it once a second with a link that is lost.
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

// REQ-CAN-23 (FdcanusbProbeTest.*): A port behind which no adapter answers gets one question and nothing else, and is
// given back, until the operator acts or another device takes its place. A stall of this computer is no silence.
TEST_F(FdcanusbProbeTest, SilentPortHearsOneQuestionAndNothingElse)
{
    openPort();
    reopenFor(60s);
    ASSERT_TRUE(waitUntil([this] { return port.written == fakes::kProbe; })) << port.written.toStdString();
    EXPECT_EQ(link.status().state, LinkState::Lost);
    EXPECT_TRUE(link.status().leftAlone);
    EXPECT_EQ(link.status().sent, 0U);
    EXPECT_THAT(link.status().text.toStdString(), HasSubstr("no fdcanusb answers on this port"));
    EXPECT_EQ(link.open().error().text, link.status().text.toStdString());
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

// Nobody sends while the station is closing, and the port is to be free for its own program.
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

// The right adapter comes after the wrong port: plugged in under the same name.
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

// Its answer waits to be read when this computer wakes up.
TEST_F(FdcanusbProbeTest, StallOfThisComputerIsNoSilenceOfTheAdapter)
{
    openPort();
    ASSERT_TRUE(waitUntil([this] { return port.written == fakes::kProbe; }));
    port.takeWritten();
    port.write("lec=0 dlec=0 err=0 warn=0 busoff=0\r\n");
    pollfd arrived{.fd = ::open(port.path().toLocal8Bit().constData(), O_RDONLY | O_NOCTTY | O_CLOEXEC),
                   .events = POLLIN,
                   .revents = 0};
    ASSERT_EQ(poll(&arrived, 1, 5000), 1);
    ::close(arrived.fd);
    clock.advance(5s);
    tick();
    EXPECT_TRUE(waitUntil([this] {
        tick();
        return port.written.startsWith("can send");
    }));
}

// Story: a second program of another user took the adapter of the running service. It sees neither the open files of
// the service nor the folder of its lock file. Here the holder is this program itself, which the look at /proc leaves
// out.
// REQ-CAN-19
TEST_F(FdcanusbLinkTest, PortThatIsLockedInAnyWayIsRefused)
{
    link.close();
    const FileDescriptor holder(::open(adapter.path().toLocal8Bit().constData(), O_RDWR | O_NOCTTY | O_CLOEXEC));
    ASSERT_EQ(flock(holder.number(), LOCK_EX | LOCK_NB), 0);
    const auto busy = link.open();
    ASSERT_FALSE(busy.has_value());
    EXPECT_EQ(busy.error().code, ErrorCode::Busy);
    EXPECT_EQ(busy.error().text, adapter.path().toStdString() + " is in use by can_test (process " +
                                     std::to_string(getpid()) + "): end it first");
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

// The kernel's exclusive mark stays on real ports: those of USB adapters (166, 188) and of the board (4).
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
    ASSERT_TRUE(!root || seteuid(kNobody) == 0);  // root may open anything
    const auto result = link.open();
    ASSERT_TRUE(!root || seteuid(0) == 0);
    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(result.error().code, ErrorCode::Denied);
    EXPECT_THAT(result.error().text, HasSubstr("70-boresight-fdcanusb.rules"));
    EXPECT_THAT(result.error().text, HasSubstr("group dialout"));
}

}  // namespace
}  // namespace boresight
