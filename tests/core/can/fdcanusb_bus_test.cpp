// SPDX-License-Identifier: GPL-3.0-or-later
// The bus status that the adapter reports, and how the link restarts its controller.
#include "tests/core/can/fdcanusb_rig.h"

namespace boresight {
namespace {

using namespace std::chrono_literals;
using fakes::waitUntil;
using testing::HasSubstr;

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
    sendOne();  // refused again, but a restart is sent only once a second
    adapter.write("ERR not in BusOn state\r\n");
    ASSERT_TRUE(waitUntil([this] { return link.status().busErrors == 2; }));
    EXPECT_TRUE(written("can send 8001 50 BF\ncan status\n"));

    adapter.write("rcv 0100 210000 e B F r x-1\r\n");
    ASSERT_TRUE(waitUntil([this] { return link.status().state == LinkState::Up; }));
    EXPECT_EQ(text(), "");
}

// The firmware confirms frames with OK although its controller is bus-off. Only "can status" shows this. The query goes
// out after 200 ms of silence, so the result is on the screen within 300 ms.
// REQ-CAN-07: A silent adapter is queried for its bus status after 200 ms. Bus-off is reported, and the controller is
// restarted at most once a second.
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
    EXPECT_THAT(text(), HasSubstr("no board acknowledges the frames: check the power of the drives, the cable"));
    adapter.write("rcv 0100 210000 e B F r x-1\r\n");
    ASSERT_TRUE(waitUntil([this] { return text().empty(); }));
}

// Story: an adapter that is bus-off refuses frames too, and the two texts alternated in the log five times a second.
TEST_F(FdcanusbLinkTest, BusOffIsNotHiddenByTheRefusalsThatFollow)
{
    clock.advance(200ms);
    sendOne();
    adapter.write("OK\r\nlec=3 dlec=7 err=1 warn=1 busoff=1 pexc=0 tdc=0\r\n");
    ASSERT_TRUE(waitUntil([this] { return link.status().state == LinkState::Down; }));
    const QString told = link.status().text;
    EXPECT_THAT(text(), HasSubstr("bus-off after too many errors"));
    const std::uint64_t errors = link.status().busErrors;
    adapter.write("OK\r\nOK\r\n");  // the replies to the restart
    sendOne();
    adapter.write("ERR not in BusOn state\r\n");
    ASSERT_TRUE(waitUntil([&] { return link.status().busErrors == errors + 1; }));
    EXPECT_EQ(link.status().text, told);
}

// An adapter that stays bus-off is queried five times a second, and restarted once a second.
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
        sendOne();  // brings earlier output with it
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

}  // namespace
}  // namespace boresight
