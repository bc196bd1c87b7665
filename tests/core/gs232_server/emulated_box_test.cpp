// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232_server/emulated_box.h"

#include "core/rotctld/server.h"
#include "tests/fakes/dummy_rotator.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/tcp_peer.h"

#include <QCoreApplication>

#include <gtest/gtest.h>

#include <chrono>
#include <string>

namespace boresight::gs232 {
namespace {

using namespace std::chrono_literals;

struct EmulatedBoxTest : ::testing::Test
{
    // Everything that is answered to these bytes.
    std::string say(std::string_view bytes)
    {
        talk->receive(bytes);
        std::string replies;
        while (talk->step(replies)) {
        }
        return replies;
    }
    void begin(Dialect dialect)
    {
        talk = talkGs232(rotator, clock, dialect)({.id = 7, .address = "127.0.0.1:5", .protocol = "GS-232B"});
    }
    [[nodiscard]] std::string place() { return say("C2\r"); }

    fakes::ManualClock clock;
    fakes::DummyRotator rotator{clock};
    std::unique_ptr<rotctld::Conversation> talk =
        talkGs232(rotator, clock, Dialect::B)({.id = 7, .address = "127.0.0.1:5", .protocol = "GS-232B"});
};

using EmulatedBoxOnALine = EmulatedBoxTest;

// REQ-GS232SERVER-03 (EmulatedBoxOnALine.*): A GS-232 client points, turns, stops and reads the mount by the same
// requests as a rotctld client. Each accepted command is answered with CR. An empty command is not answered.
TEST_F(EmulatedBoxOnALine, PointsAndReads)
{
    EXPECT_EQ(say("W060 030\r"), "\r");
    ASSERT_TRUE(rotator.lastRequest);
    EXPECT_EQ(rotator.lastRequest->azimuth, 60_deg);
    EXPECT_EQ(rotator.lastRequest->elevation, 30_deg);
    clock.advance(4s);  // 6°/s
    EXPECT_EQ(place(), "AZ=024  EL=024\r\n");
    clock.advance(20s);
    EXPECT_EQ(place(), "AZ=060  EL=030\r\n");
    begin(Dialect::A);
    EXPECT_EQ(place(), "+0060+0030\r\n");
}

TEST_F(EmulatedBoxOnALine, TheAzimuthAloneLeavesTheElevation)
{
    static_cast<void>(say("W060 030\r"));
    clock.advance(20s);
    EXPECT_EQ(say("M090\r"), "\r");
    clock.advance(20s);
    EXPECT_EQ(place(), "AZ=090  EL=030\r\n");
}

// Story: each M pointed to the measured elevation, so a mount that sags moved down a little each time.
TEST_F(EmulatedBoxOnALine, ManyAzimuthsDoNotLowerTheElevation)
{
    static_cast<void>(say("W060 030\r"));
    clock.advance(20s);
    rotator.sag = 0.4_deg;
    for (const char* const azimuth : {"M070\r", "M080\r", "M090\r", "M100\r"}) {
        EXPECT_EQ(say(azimuth), "\r");
        clock.advance(10s);
    }
    EXPECT_EQ(rotator.lastRequest->elevation, 30_deg);
    static_cast<void>(say("W100 000\r"));
    clock.advance(20s);
    EXPECT_EQ(say("M110\r"), "\r");
    EXPECT_EQ(rotator.lastRequest->elevation, 0_deg);
}

TEST_F(EmulatedBoxOnALine, EachStopStops)
{
    for (const char* const stop : {"S\r", "A\r", "E\r", "s\r"}) {
        static_cast<void>(say("W400 090\r"));
        clock.advance(1s);
        EXPECT_EQ(say(stop), "\r");
        const std::string stopped = place();
        clock.advance(10s);
        EXPECT_EQ(place(), stopped) << stop;
    }
}

TEST_F(EmulatedBoxOnALine, TurnsAtTheSpeedThatWasChosen)
{
    EXPECT_EQ(say("X3\rR\r"), "\r\r");
    EXPECT_EQ(rotator.speedLevel(), 3);
    EXPECT_EQ(rotator.lastSpeed, -1) << "that of the level";
    EXPECT_EQ(rotator.mover, 7U);
    clock.advance(2s);
    EXPECT_EQ(place(), "AZ=012  EL=000\r\n");
    EXPECT_EQ(say("L\rS\r"), "\r\r");
    EXPECT_EQ(rotator.mover, 0U);
}

TEST_F(EmulatedBoxOnALine, TakesAnyPiecesAndAnyLineEnds)
{
    EXPECT_EQ(say("W06"), "");
    EXPECT_TRUE(talk->midCommand());
    EXPECT_EQ(rotator.actions, 0);
    EXPECT_EQ(say("0 030\r\r"), "\r") << "the second CR of Hamlib's GS-232B is nothing";
    EXPECT_FALSE(talk->midCommand());
    EXPECT_EQ(say("\r\n\r\nC2\r\nS\n"), "AZ=000  EL=000\r\n\r");
}

class EmulatedBoxThat : public EmulatedBoxTest
{};

TEST_F(EmulatedBoxThat, RefusesMovesNothing)
{
    for (const char* const line : {"W123\r", "W451 000\r", "W010 123 045\r", "O\r", "AZ10 EL20\r", "P45\r", "Z\r"}) {
        EXPECT_EQ(say(line), "?>\r\n") << line;
    }
    EXPECT_EQ(rotator.actions, 0);
    EXPECT_TRUE(talk->ending().isEmpty());
    EXPECT_TRUE(talk->habits().lastInWords().contains(QStringLiteral("not supported")));
}

// REQ-GS232SERVER-04: A position that is unknown or old is answered with `?>`, never with a number. A command that the
// station refuses is answered with `?>`, too.
TEST_F(EmulatedBoxThat, HasNoPositionSaysSo)
{
    static_cast<void>(say("W060 030\r"));
    clock.advance(20s);
    rotator.fault = Error{.code = ErrorCode::NoAnswer, .text = QStringLiteral("the drives are silent")};
    for (const char* const question : {"C\r", "B\r", "C2\r", "M090\r", "W010 010\r", "R\r", "X2\r"}) {
        EXPECT_EQ(say(question), "?>\r\n") << question;
    }
    EXPECT_TRUE(talk->ending().isEmpty()) << "no fault of the client";
}

TEST_F(EmulatedBoxThat, HearsNonsenseHangsUp)
{
    std::string eight;
    for (int i = 0; i < 8; ++i) {
        eight += "nonsense\r";
    }
    const std::string replies = say(eight + "W010 010\r");
    EXPECT_EQ(replies.size(), 8 * kRefusal.size());
    EXPECT_TRUE(talk->dropped());
    EXPECT_EQ(rotator.actions, 0);
    EXPECT_EQ(rotator.remarks.size(), 3U) << "of eight";
}

TEST_F(EmulatedBoxThat, HearsABrowserHangsUpWithoutAWord)
{
    EXPECT_EQ(say("POST / HTTP/1.1\r\nHost: x\r\n\r\nW010 010\r"), "");
    EXPECT_TRUE(talk->dropped());
    EXPECT_EQ(rotator.actions, 0);
}

TEST_F(EmulatedBoxThat, HearsNoLineEndHangsUp)
{
    EXPECT_EQ(say(std::string(4097, 'W')), "");
    EXPECT_TRUE(talk->dropped());
}

TEST_F(EmulatedBoxThat, IsLeftForgetsHalfACommand)
{
    EXPECT_EQ(say("W010 01"), "");
    talk->endOfInput();
    EXPECT_EQ(say(""), "");
    EXPECT_FALSE(talk->ending().isEmpty());
    EXPECT_FALSE(talk->dropped());
    EXPECT_EQ(rotator.actions, 0) << "010 010 was perhaps meant";
}

TEST_F(EmulatedBoxThat, IsInTheListOfClients)
{
    static_cast<void>(say("W060 030\r"));
    EXPECT_EQ(talk->habits().lastCommand(), QStringLiteral("W060 030"));
    EXPECT_EQ(talk->habits().lastMotion(), clock.now());
    rotator.fault = Error{.code = ErrorCode::Refused, .text = QStringLiteral("STOP is latched")};
    static_cast<void>(say("R\r"));
    EXPECT_TRUE(talk->habits().lastInWords().contains(QStringLiteral("STOP is latched")));
}

// REQ-GS232SERVER-05: At a port a GS-232 client is served like a rotctld client: the allow list, the end of its turning
// when it vanishes, and its number and protocol in the list.
TEST(Gs232Port, ServesAsTheRotctldPortDoes)
{
    fakes::ManualClock clock;
    fakes::DummyRotator rotator{clock};
    rotctld::Server server({.port = 0, .protocol = "GS-232A", .newestClient = std::make_shared<std::uint64_t>(5000)},
                           talkGs232(rotator, clock, Dialect::A), rotator, clock);
    ASSERT_TRUE(server.listen());
    const auto turn = [] { QCoreApplication::processEvents(QEventLoop::AllEvents); };
    fakes::TcpPeer peer("127.0.0.1", server.port(), turn);
    EXPECT_EQ(peer.ask("C2\r"), "+0000+0000\r\n");
    ASSERT_EQ(server.clients().size(), 1U);
    EXPECT_EQ(server.clients().front().id, 5001U);
    EXPECT_EQ(server.clients().front().program, "GS-232A");
    static_cast<void>(peer.send("R\rC2\r"));
    EXPECT_EQ(peer.receiveLines(1), "\r+0000+0000\r\n");
    EXPECT_EQ(rotator.mover, 5001U);
    peer.reset();
    while (rotator.gone.empty()) {
        turn();
    }
    EXPECT_EQ(rotator.mover, 0U) << "its turning has ended";
}

}  // namespace
}  // namespace boresight::gs232
