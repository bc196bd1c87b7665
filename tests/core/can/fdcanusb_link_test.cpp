// SPDX-License-Identifier: GPL-3.0-or-later
// Frames and their replies, line by line.
#include "core/can/line_checksum.h"
#include "tests/core/can/fdcanusb_rig.h"
#include "tests/fakes/text_of.h"

namespace boresight {
namespace {

using namespace std::chrono_literals;
using fakes::waitUntil;
using testing::HasSubstr;

// REQ-CAN-05: The frames of both axes leave in one write. A batch that stops halfway reports how many frames were sent.
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

// REQ-CAN-06: An OK that does not come within 50 ms, and every ERR, is counted. It is reported until a frame is
// confirmed again.
TEST_F(FdcanusbLinkTest, MissingOkIsCountedAndSaidUntilTheNextOk)
{
    ASSERT_TRUE(link.send(std::array{frameTo(0x8001, {0x50}), frameTo(0x8002, {0x50})}).has_value());
    clock.advance(49ms);
    sendOne();
    EXPECT_EQ(link.status().busErrors, 0U);
    clock.advance(1ms);  // the first two are overdue, and the timer detects it by itself
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
                          ": the adapter refuses a frame: invalid data. Check its firmware and its can.* "
                          "settings");
    EXPECT_EQ(link.status().busErrors, 1U);
    EXPECT_EQ(link.status().state, LinkState::Up);
    clock.advance(1s);
    sendOne();
    EXPECT_EQ(link.status().busErrors, 1U);  // the ERR was the reply, so nothing is missing
}

// Found by the fuzzer: a damaged refusal appeared on the screen and in the log with its control characters.
TEST_F(FdcanusbLinkTest, ShowsADamagedRefusalPrintable)
{
    sendOne();
    adapter.write("ERR inv\x1b[2Jalid\x7f\r\n");
    ASSERT_TRUE(waitUntil([this] { return link.status().busErrors == 1; }));
    EXPECT_EQ(text(), link.name().toStdString() +
                          ": the adapter refuses a frame: inv?[2Jalid?. Check its firmware and its can.* settings");
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
    // Nobody reads the pseudo-terminal here: its buffer fills up, then that of the link.
    for (int i = 0; i < 10000 && result; ++i) {
        result = link.send(std::array{frameTo(0x8001, {0x50})});
    }
    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(result.error().code, ErrorCode::NoAnswer);
    EXPECT_THAT(textOf(result.error()), HasSubstr("accepts no more data"));
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

// REQ-CAN-08: Checksum mode adds checksums and accepts no line without one.
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

}  // namespace
}  // namespace boresight
