// SPDX-License-Identifier: GPL-3.0-or-later
// SocketCanLink over a socket pair in place of AF_CAN: this runs on any kernel and under the sanitizers. Tests that
// need a real interface are in socketcan_link_test.cpp, which runs in User-Mode Linux.
#include "core/can/socketcan_link.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/text_of.h"
#include "tests/fakes/wait_until.h"

#include <QSignalSpy>

#include <gmock/gmock.h>
#include <linux/can/error.h>
#include <sys/socket.h>

#include <array>

namespace boresight {
namespace {

using fakes::waitUntil;
using socketcan::InterfaceState;
using socketcan::RawFrame;
using testing::HasSubstr;

class FakeInterface final : public socketcan::CanInterface
{
public:
    Result<FileDescriptor> openSocket() override
    {
        if (refusal) {
            return tl::unexpected(*refusal);
        }
        std::array<int, 2> ends{};
        EXPECT_EQ(socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, ends.data()), 0);
        bus = FileDescriptor(ends[1]);
        return FileDescriptor(ends[0]);
    }
    [[nodiscard]] InterfaceState state() const override { return current; }
    [[nodiscard]] std::optional<socketcan::InterfaceReport> report() const override { return told; }
    void become(InterfaceState state)
    {
        current = state;
        Q_EMIT changed();
    }
    void put(const RawFrame& raw) const
    {
        EXPECT_EQ(::send(bus.number(), &raw.frame, raw.size, MSG_NOSIGNAL), static_cast<ssize_t>(raw.size));
    }

    std::optional<Error> refusal;
    InterfaceState current = InterfaceState::Up;
    std::optional<socketcan::InterfaceReport> told;
    FileDescriptor bus;
};

CanFrame frameTo(std::uint32_t id)
{
    CanFrame frame;
    frame.id = id;
    frame.extended = id > kMaxStandardId;
    frame.setPayload(std::array<std::uint8_t, 1>{0x50});
    return frame;
}

class SocketCanFakeTest : public testing::Test
{
protected:
    SocketCanFakeTest() : SocketCanFakeTest(std::make_unique<FakeInterface>()) {}
    explicit SocketCanFakeTest(std::unique_ptr<FakeInterface> access)
        : can(*access), link(QStringLiteral("can0"), std::move(access), clock)
    {}
    void SetUp() override
    {
        ASSERT_TRUE(link.open().has_value());
        changes.clear();
    }

    [[nodiscard]] std::string text() const { return link.status().text.toStdString(); }
    [[nodiscard]] bool becomes(LinkState state) const
    {
        return waitUntil([this, state] { return link.status().state == state; });
    }
    void putError(canid_t errorClass, std::uint8_t controller = 0) const
    {
        RawFrame raw;
        raw.size = CAN_MTU;
        raw.frame.can_id = CAN_ERR_FLAG | errorClass;
        raw.frame.len = CAN_ERR_DLC;
        raw.frame.data[1] = controller;
        can.put(raw);
    }

    fakes::ManualClock clock;
    FakeInterface& can;
    SocketCanLink link;
    QSignalSpy frames{&link, &CanLink::frameReceived};
    QSignalSpy changes{&link, &CanLink::statusChanged};
};

TEST_F(SocketCanFakeTest, FramesGoOutAndComeInStamped)
{
    ASSERT_TRUE(link.send(std::array{frameTo(0x8001), frameTo(0x8002)}).has_value());
    for (const std::uint32_t id : {0x8001U, 0x8002U}) {
        RawFrame raw;
        raw.size = static_cast<std::size_t>(recv(can.bus.number(), &raw.frame, sizeof raw.frame, 0));
        EXPECT_EQ(socketcan::fromRaw(raw), frameTo(id));
    }
    can.put(socketcan::toRaw(frameTo(0x100)).value());
    ASSERT_TRUE(waitUntil([this] { return frames.size() == 1; }));
    const auto frame = qvariant_cast<CanFrame>(frames.at(0).at(0));
    EXPECT_EQ(frame, frameTo(0x100));
    EXPECT_EQ(frame.received, clock.now());
    EXPECT_EQ(link.status(), (LinkStatus{.state = LinkState::Up, .text = {}, .sent = 2, .received = 1}));
}

TEST_F(SocketCanFakeTest, InterfaceDownAndUpAgainIsFollowed)
{
    can.become(InterfaceState::Down);
    EXPECT_EQ(link.status().state, LinkState::Down);
    EXPECT_THAT(text(),
                HasSubstr("`ip link set can0 up type can bitrate 1000000 dbitrate 5000000 sjw 10 dsjw 5 sample-point "
                          "0.666"));
    can.become(InterfaceState::Up);
    EXPECT_EQ(link.status().state, LinkState::Up);
    EXPECT_EQ(text(), "");
    EXPECT_EQ(changes.size(), 2);
}

TEST_F(SocketCanFakeTest, OpensAnInterfaceThatIsDown)
{
    can.current = InterfaceState::Down;
    ASSERT_TRUE(link.open().has_value());
    EXPECT_EQ(link.status().state, LinkState::Down);
    EXPECT_THAT(text(), HasSubstr("is down"));
}

TEST_F(SocketCanFakeTest, RemovedInterfaceIsLostUntilOpenedAgain)
{
    can.become(InterfaceState::Absent);
    EXPECT_EQ(link.status().state, LinkState::Lost);
    EXPECT_THAT(text(), HasSubstr("removed"));
    EXPECT_EQ(textOf(link.send(std::array{frameTo(0x8001)}).error()), text());
    can.become(InterfaceState::Up);
    EXPECT_EQ(link.status().state, LinkState::Lost);
    ASSERT_TRUE(link.open().has_value());
    EXPECT_EQ(link.status().state, LinkState::Up);
}

TEST_F(SocketCanFakeTest, BusOffIsDownUntilTheControllerRestarts)
{
    putError(CAN_ERR_BUSOFF);
    ASSERT_TRUE(becomes(LinkState::Down));
    EXPECT_THAT(text(), HasSubstr("bus-off"));
    EXPECT_EQ(link.status().busErrors, 1U);
    can.become(InterfaceState::Up);  // the interface reports a change, but not a restart
    EXPECT_EQ(link.status().state, LinkState::Down);
    putError(CAN_ERR_RESTARTED);
    ASSERT_TRUE(becomes(LinkState::Up));
    EXPECT_EQ(text(), "");
    EXPECT_EQ(link.status().busErrors, 1U);
}

// REQ-CAN-11
TEST_F(SocketCanFakeTest, ErrorPassiveAndMissingAcknowledgeAreSaidUntilAFrameComesThrough)
{
    putError(CAN_ERR_CRTL, CAN_ERR_CRTL_TX_PASSIVE);
    ASSERT_TRUE(waitUntil([this] { return link.status().busErrors == 1; }));
    EXPECT_THAT(text(), HasSubstr("error-passive"));
    putError(CAN_ERR_ACK);
    ASSERT_TRUE(waitUntil([this] { return link.status().busErrors == 2; }));
    EXPECT_THAT(text(), HasSubstr("no board acknowledges the frames: check the power of the drives, the cable"));
    EXPECT_EQ(link.status().state, LinkState::Up);
    can.put(socketcan::toRaw(frameTo(0x100)).value());
    ASSERT_TRUE(waitUntil([this] { return frames.size() == 1; }));
    EXPECT_EQ(text(), "");
}

TEST_F(SocketCanFakeTest, FloodOfErrorFramesIsSaidOnceAndCounted)
{
    for (int i = 0; i < 50; ++i) {
        putError(CAN_ERR_PROT | CAN_ERR_BUSERROR);
        putError(CAN_ERR_CRTL, CAN_ERR_CRTL_RX_OVERFLOW);
    }
    ASSERT_TRUE(waitUntil([this] { return link.status().busErrors == 100; }));
    EXPECT_EQ(link.status().dropped, 50U);
    EXPECT_EQ(changes.size(), 1);
    EXPECT_EQ(link.status().state, LinkState::Up);
    EXPECT_THAT(text(), HasSubstr("damaged frames on the bus: check the drives' power, the cable"));
}

// Good frames arrive between the damaged ones. The text must not flicker, and must disappear when the damage is over.
// REQ-CAN-11
TEST_F(SocketCanFakeTest, DamagedFramesAreForgottenAfterASecondWithout)
{
    qsizetype count = 0;
    const auto receiveOne = [this, &count] {
        can.put(socketcan::toRaw(frameTo(0x100)).value());
        ++count;
        return waitUntil([this, &count] { return frames.size() == count; });
    };
    for (int i = 0; i < 3; ++i) {
        putError(CAN_ERR_PROT | CAN_ERR_BUSERROR);
        ASSERT_TRUE(receiveOne());
        clock.advance(std::chrono::milliseconds(900));
    }
    EXPECT_EQ(changes.size(), 1);
    EXPECT_THAT(text(), HasSubstr("damaged frames"));
    clock.advance(std::chrono::milliseconds(100));
    ASSERT_TRUE(receiveOne());
    EXPECT_EQ(text(), "");
}

// Some drivers report a missing acknowledge as a protocol violation in the acknowledge slot.
// REQ-CAN-11
TEST_F(SocketCanFakeTest, MissingAcknowledgeIsKnownByItsPlaceInTheFrame)
{
    RawFrame raw;
    raw.size = CAN_MTU;
    raw.frame.can_id = CAN_ERR_FLAG | CAN_ERR_PROT | CAN_ERR_BUSERROR;
    raw.frame.len = CAN_ERR_DLC;
    raw.frame.data[3] = CAN_ERR_PROT_LOC_ACK;
    can.put(raw);
    ASSERT_TRUE(waitUntil([this] { return !text().empty(); }));
    EXPECT_THAT(text(), HasSubstr("no board acknowledges"));
}

// A flood of frames is a warning after one window of 200 ms, and stays a warning until the bus is quiet again.
// REQ-CAN-20
TEST_F(SocketCanFakeTest, FloodOfAnotherProgramIsSaid)
{
    qsizetype count = 0;
    const auto receiveOver = [this, &count](int number, std::chrono::milliseconds time) {
        for (int i = 0; i < number; ++i) {
            clock.advance(Seconds(time) / number);
            can.put(socketcan::toRaw(frameTo(0x005)).value());
            ++count;
            if (!waitUntil([this, &count] { return frames.size() == count; })) {
                return false;
            }
        }
        return true;
    };
    using std::chrono::milliseconds;
    ASSERT_TRUE(receiveOver(390, milliseconds(199)));  // just shorter than a window
    EXPECT_EQ(text(), "");
    ASSERT_TRUE(receiveOver(30, milliseconds(2)));
    EXPECT_EQ(link.status().state, LinkState::Up);
    EXPECT_THAT(text(), HasSubstr("more than 2000 frames a second on the bus"));
    EXPECT_THAT(text(), HasSubstr("Another program floods the bus. End that program (`candump can0`"));
    ASSERT_TRUE(receiveOver(300, milliseconds(201)));  // 1500 a second: still a flood
    EXPECT_EQ(changes.size(), 1);
    ASSERT_TRUE(receiveOver(40, milliseconds(201)));  // two drives at 100 Hz
    EXPECT_EQ(text(), "");
}

class SocketCanTimingTest : public SocketCanFakeTest
{
protected:
    static socketcan::InterfaceReport adapter()
    {
        return {.index = 3,
                .name = "can0",
                .up = true,
                .kind = "can",
                .nominal = socketcan::PhaseTiming{.bitRate = 1'000'000, .samplePoint = 0.666},
                .data = socketcan::PhaseTiming{.bitRate = 5'000'000, .samplePoint = 0.666},
                .flexibleData = true,
                .controller = socketcan::ControllerState::Active,
                .errors = std::nullopt};
    }
};

// REQ-CAN-15 (SocketCanTimingTest.*)
TEST_F(SocketCanTimingTest, WrongBitRateIsAWarningUntilTheInterfaceIsSetRight)
{
    can.told = adapter();
    can.told->nominal->bitRate = 500'000;
    ASSERT_TRUE(link.open().has_value());
    EXPECT_EQ(link.status().state, LinkState::Up);
    EXPECT_THAT(text(), HasSubstr("socketcan:can0: wrong bit timing"));
    EXPECT_THAT(text(), HasSubstr("bit rate 500000 (wanted 1000000)"));
    EXPECT_THAT(text(), HasSubstr("`ip -details link show can0`"));
    can.become(InterfaceState::Down);
    EXPECT_THAT(text(), HasSubstr("the interface is down. Bring it up with `ip link set can0 up type can"));
    can.told = adapter();
    can.become(InterfaceState::Up);
    EXPECT_EQ(text(), "");
}

TEST_F(SocketCanTimingTest, WrongTimingIsToldBesideWhatItCauses)
{
    can.told = adapter();
    can.told->data->samplePoint = 0.75;
    ASSERT_TRUE(link.open().has_value());
    putError(CAN_ERR_ACK);
    ASSERT_TRUE(waitUntil([this] { return link.status().busErrors == 1; }));
    EXPECT_THAT(text(), testing::ContainsRegex("no board acknowledges.*; wrong bit timing.*data sample point 0.750"));
}

// A bus that was off before the program started sends no error frame about it.
// REQ-CAN-11
TEST_F(SocketCanTimingTest, BusOffFromBeforeIsSeenAtOpening)
{
    can.told = adapter();
    can.told->controller = socketcan::ControllerState::BusOff;
    ASSERT_TRUE(link.open().has_value());
    EXPECT_EQ(link.status().state, LinkState::Down);
    EXPECT_THAT(text(), HasSubstr("bus-off"));
    EXPECT_THAT(text(), HasSubstr("`ip link set can0 type can restart`"));
    can.told->controller = socketcan::ControllerState::Passive;
    can.become(InterfaceState::Up);
    EXPECT_EQ(link.status().state, LinkState::Up);
    EXPECT_THAT(text(), HasSubstr("error-passive"));
    can.told = adapter();
    can.become(InterfaceState::Up);
    EXPECT_EQ(text(), "");
}

TEST_F(SocketCanFakeTest, FullTransmitQueueTellsHowManyFramesLeft)
{
    std::vector<CanFrame> batch(100000, frameTo(0x8001));  // far more than a socket buffer holds, and nobody reads
    const auto result = link.send(batch);
    ASSERT_FALSE(result.has_value());
    const auto sent = link.status().sent;
    EXPECT_GT(sent, 0U);
    EXPECT_THAT(textOf(result.error()), HasSubstr("transmit queue is full"));
    EXPECT_THAT(textOf(result.error()), HasSubstr("(" + std::to_string(sent) + " of 100000 frames sent)"));
    EXPECT_EQ(link.status().state, LinkState::Up);

    RawFrame raw;
    while (recv(can.bus.number(), &raw.frame, sizeof raw.frame, 0) > 0) {
    }
    ASSERT_TRUE(link.send(std::array{frameTo(0x8001)}).has_value());
    EXPECT_EQ(text(), "");
}

// REQ-CAN-04
TEST_F(SocketCanFakeTest, ImpossibleFrameIsRefusedAndNothingOfTheBatchIsSent)
{
    EXPECT_EQ(link.send(std::array{frameTo(0x8001), frameTo(0x20000000)}).error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(link.status().sent, 0U);
}

TEST_F(SocketCanFakeTest, BrokenSocketIsLostNotIgnored)
{
    can.bus.reset();
    EXPECT_TRUE(becomes(LinkState::Lost));
}

// REQ-CAN-14: The receiver of a frame may close the link.
TEST_F(SocketCanFakeTest, ReceiverMayCloseTheLink)
{
    QObject::connect(&link, &CanLink::frameReceived, &link, &CanLink::close);
    can.put(socketcan::toRaw(frameTo(0x100)).value());
    can.put(socketcan::toRaw(frameTo(0x200)).value());
    ASSERT_TRUE(becomes(LinkState::Closed));
    EXPECT_EQ(frames.size(), 1);
    EXPECT_THAT(textOf(link.send(std::array{frameTo(0x8001)}).error()), HasSubstr("not open"));
}

TEST_F(SocketCanFakeTest, OpenErrorIsPassedOn)
{
    can.refusal = Error{ErrorCode::NoDevice, QStringLiteral("there is no interface can0")};
    EXPECT_EQ(link.open().error(), *can.refusal);
    EXPECT_EQ(link.status().state, LinkState::Closed);
}

}  // namespace
}  // namespace boresight
