// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/easycomm_server/easycomm_controller.h"

#include "core/base/version.h"
#include "core/rotctld/server.h"
#include "tests/fakes/dummy_rotator.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/tcp_peer.h"

#include <QCoreApplication>

#include <gtest/gtest.h>

#include <chrono>
#include <string>

namespace boresight::easycomm {
namespace {

using namespace std::chrono_literals;

struct EasycommTest : ::testing::Test
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
    void begin(Version version)
    {
        talk = talkEasycomm(rotator, clock, version)({.id = 7, .address = "127.0.0.1:5", .protocol = "EasyComm"});
    }
    [[nodiscard]] std::string place() { return say("AZ EL \n"); }
    void refuse(ErrorCode code) { rotator.fault = Error{.code = code, .text = QStringLiteral("not now")}; }

    fakes::ManualClock clock;
    fakes::DummyRotator rotator{clock};
    std::unique_ptr<rotctld::Conversation> talk =
        talkEasycomm(rotator, clock, Version::Three)({.id = 7, .address = "127.0.0.1:5", .protocol = "EasyComm III"});
};

using EasycommOnALine = EasycommTest;

// REQ-EASYCOMMSERVER-03 (EasycommOnALine.*): An EasyComm client points, turns, stops, parks and reads the mount by the
// same requests as a rotctld client. Commands are not answered. All queries of a line are answered on one line.
TEST_F(EasycommOnALine, PointsAndReads)
{
    EXPECT_EQ(say("AZ60.2 EL30.4\n"), "");
    ASSERT_TRUE(rotator.lastRequest);
    EXPECT_NEAR(rotator.lastRequest->azimuth.degrees(), 60.2, 1e-9);
    EXPECT_NEAR(rotator.lastRequest->elevation.degrees(), 30.4, 1e-9);
    clock.advance(4s);  // 6°/s
    EXPECT_EQ(place(), "AZ24.0 EL24.0\n");
    clock.advance(20s);
    EXPECT_EQ(place(), "AZ60.2 EL30.4\n");
    EXPECT_EQ(say("AZ\n"), "AZ60.2\n") << "as Hamlib 4.6 asks";
    EXPECT_EQ(say("EL\r\n"), "EL30.4\n");
    EXPECT_EQ(say("AZ10.0 EL10.0 AZ EL\n"), "AZ60.2 EL30.4\n");
    EXPECT_EQ(rotator.actions, 2);
}

TEST_F(EasycommOnALine, ASingleLineOfTheFirstVersionPoints)
{
    begin(Version::One);
    EXPECT_EQ(say("AZ60.0 EL30.0 UP000 XXX DN000 XXX\n"), "");
    clock.advance(20s);
    EXPECT_EQ(place(), "AZ60.0 EL30.0\n");
    EXPECT_EQ(say("AZ10.0 EL30.0 UP145900000 FM DN435000000 SSB\n"), "");
    clock.advance(1s);
    EXPECT_EQ(say("SA SE \n"), "");
    EXPECT_EQ(place(), "AZ54.0 EL30.0\n");
    EXPECT_EQ(say("ML\n"), "") << "nothing but places is answered";
    EXPECT_EQ(rotator.mover, 0U);
}

// The controller keeps a set-point for each axis.
TEST_F(EasycommOnALine, OneAxisAloneLeavesTheOtherWhereItWasSent)
{
    static_cast<void>(say("AZ60.0 EL30.0\n"));
    clock.advance(1s);
    EXPECT_EQ(say("AZ90.0\n"), "");
    EXPECT_EQ(rotator.lastRequest->elevation, 30_deg) << "on the way there";
    clock.advance(1s);
    EXPECT_EQ(say("EL40.0\n"), "");
    EXPECT_EQ(rotator.lastRequest->azimuth, 90_deg);
    clock.advance(30s);
    EXPECT_EQ(place(), "AZ90.0 EL40.0\n");
    rotator.sag = 0.4_deg;
    for (const char* const azimuth : {"AZ70\n", "AZ80\n", "AZ70\n"}) {
        static_cast<void>(say(azimuth));
        EXPECT_EQ(rotator.lastRequest->elevation, 40_deg) << "a mount that sags goes down no further";
        clock.advance(30s);
    }
}

TEST_F(EasycommOnALine, OneAxisAloneOfALongWayLeavesTheOtherOnIt)
{
    static_cast<void>(say("AZ0.0 EL90.0\n"));
    clock.advance(12s);
    static_cast<void>(say("AZ30.0\n"));
    EXPECT_EQ(rotator.lastRequest->elevation, 90_deg);
}

TEST_F(EasycommOnALine, OneAxisAloneLeavesTheOtherAtTheTargetOfTheMount)
{
    static_cast<void>(say("AZ60.0 EL30.0\n"));
    clock.advance(2s);
    static_cast<void>(say("SA SE\nAZ90.0\n"));
    EXPECT_EQ(rotator.lastRequest->elevation, 12_deg) << "it was stopped there";
    clock.advance(30s);
    // Another client has moved the mount since.
    static_cast<void>(rotator.pointTo({.id = 3, .address = {}}, {.azimuth = 10_deg, .elevation = 80_deg}));
    clock.advance(2s);
    static_cast<void>(say("AZ30.0\n"));
    EXPECT_EQ(rotator.lastRequest->elevation, 80_deg) << "on the way there";
    static_cast<void>(rotator.pointTo({.id = 3, .address = {}}, {.azimuth = 10_deg, .elevation = 70_deg}));
    clock.advance(60s);
    static_cast<void>(say("AZ20.0\n"));
    EXPECT_EQ(rotator.lastRequest->elevation, 70_deg);
    clock.advance(30s);
    static_cast<void>(rotator.pointTo({.id = 3, .address = {}}, {.azimuth = 20_deg, .elevation = 0_deg}));
    clock.advance(60s);
    rotator.sag = 0.3_deg;
    static_cast<void>(say("AZ25.0\n"));
    EXPECT_EQ(rotator.lastRequest->elevation, 0_deg);
}

TEST_F(EasycommOnALine, EachStopStops)
{
    for (const char* const stop : {"SA SE \n", "SA\n", "SE\n", "STOP\n", "se\r", "AZ12SA SE\n", "AZ10 45 STOP\n"}) {
        static_cast<void>(say("AZ400 EL90\n"));
        clock.advance(1s);
        static_cast<void>(say(stop));
        const std::string stopped = place();
        clock.advance(10s);
        EXPECT_EQ(place(), stopped) << stop;
    }
}

TEST_F(EasycommOnALine, TurnsUntilAStop)
{
    EXPECT_EQ(say("MR\n"), "");
    EXPECT_EQ(rotator.lastSpeed, -1) << "that of the level";
    EXPECT_FALSE(rotator.lastRate);
    EXPECT_EQ(rotator.mover, 7U);
    EXPECT_EQ(say("VU1250\n"), "");
    ASSERT_TRUE(rotator.lastRate);
    EXPECT_NEAR(rotator.lastRate->degrees(), 1.25, 1e-9);
    EXPECT_EQ(say("SA\n"), "");
    EXPECT_EQ(rotator.mover, 0U);
}

// A program that sends a rate in each cycle stops only its own turning by rates.
TEST_F(EasycommOnALine, ARateOfZeroEndsItsOwnTurning)
{
    EXPECT_EQ(say("VU1250\n"), "");
    EXPECT_EQ(say("VU0000\n"), "");
    EXPECT_EQ(rotator.mover, 0U);
    static_cast<void>(rotator.pointTo({.id = 3, .address = {}}, {.azimuth = 60_deg, .elevation = 30_deg}));
    const int before = rotator.actions;
    EXPECT_EQ(say("VL0000\nVU0000\n"), "");
    EXPECT_EQ(rotator.actions, before) << "another client has the mount";
}

TEST_F(EasycommOnALine, ReportsItsVersionAndState)
{
    EXPECT_EQ(say("VE\n"), "VEBoresight-" + std::string(kVersion) + "\n");
    EXPECT_EQ(say("GS\n;GE\n;"), "GS1\nGE0\n") << "as Hamlib asks";
    static_cast<void>(say("AZ60 EL0\n"));
    clock.advance(1s);
    EXPECT_EQ(say("GS\n"), "GS2\n");
    refuse(ErrorCode::NoAnswer);
    EXPECT_EQ(say("GS\nGE\n"), "GS8\nGE1\n");
}

TEST_F(EasycommOnALine, ParksAndResets)
{
    static_cast<void>(say("AZ60 EL30\n"));
    clock.advance(20s);
    EXPECT_EQ(say("PARK\n"), "");
    clock.advance(20s);
    EXPECT_EQ(place(), "AZ0.0 EL0.0\n");
    const int before = rotator.actions;
    EXPECT_EQ(say("RESET\n"), "");
    EXPECT_EQ(rotator.actions, before) << "it goes nowhere by that";
}

TEST_F(EasycommOnALine, TakesAnyPiecesAndAnyLineEnds)
{
    EXPECT_EQ(say("AZ60.0 EL3"), "");
    EXPECT_TRUE(talk->midCommand());
    EXPECT_EQ(rotator.actions, 0);
    EXPECT_EQ(say("0.0\r\n"), "");
    EXPECT_EQ(rotator.lastRequest->elevation, 30_deg);
    EXPECT_EQ(rotator.actions, 1);
    EXPECT_FALSE(talk->midCommand());
    EXPECT_EQ(say("\n\r\n  \nAZ\rEL\n"), "AZ0.0\nEL0.0\n");
}

class EasycommThat : public EasycommTest
{};

// REQ-EASYCOMMSERVER-04: A query without a valid value is answered by an alarm, never by a number. A line that is not
// understood is answered by an alarm, too.
TEST_F(EasycommThat, HasNoPositionSendsAnAlarm)
{
    static_cast<void>(say("AZ60 EL30\n"));
    clock.advance(20s);
    refuse(ErrorCode::NoAnswer);
    for (Version version : {Version::One, Version::Two, Version::Three}) {
        begin(version);
        for (const char* const question : {"AZ\n", "EL\n", "AZ EL \n", "AZ EL \n"}) {
            EXPECT_EQ(say(question), "ALno-position\n") << question;
        }
        EXPECT_TRUE(talk->ending().isEmpty()) << "no fault of the client";
    }
    EXPECT_EQ(say("IP1\nCR 0\n"), "ALnot-supported\nALnot-supported\n");
}

TEST_F(EasycommThat, RefusesMovesNothing)
{
    for (const char* const line : {"AZ10 EL20 ML\n", "W123 045\n", "AZ123.4EL20\n", "AZ10 45\n"}) {
        EXPECT_EQ(say(line), "ALnot-understood\n") << line;
    }
    EXPECT_EQ(say("AZ9999\n"), "ALoutside-limits\n");
    EXPECT_EQ(say("CW0,5000\n"), "ALnot-supported\n");
    EXPECT_EQ(rotator.actions, 0);
    EXPECT_TRUE(talk->ending().isEmpty());
    EXPECT_TRUE(talk->habits().lastInWords().contains(QStringLiteral("not supported")));
    begin(Version::One);
    EXPECT_EQ(say("AZ9999\nnonsense\n"), "");
}

// REQ-EASYCOMMSERVER-05: A refused motion is answered by one alarm, until a motion is accepted or the reason changes. A
// program that only sends commands reads nothing, and its terminal must not fill. EasyComm I has no alarms.
TEST_F(EasycommThat, RefusesAgainSaysSoOnce)
{
    refuse(ErrorCode::Refused);
    EXPECT_EQ(say("AZ10 EL10\n"), "ALrefused\n");
    EXPECT_EQ(say("AZ11 EL10\nAZ12 EL10\nML\nVU0100\nPARK\nSA\n"), "");
    EXPECT_EQ(say("AZ EL\n"), "ALrefused\n") << "who asks is answered";
    rotator.fault.reset();
    EXPECT_EQ(say("AZ999 EL10\n"), "ALoutside-limits\n");
    EXPECT_EQ(say("AZ10 EL10\n"), "");
    EXPECT_EQ(say("AZ999 EL10\n"), "ALoutside-limits\n");
    EXPECT_EQ(say("AZ999 EL10 AZ EL\n"), "AZ0.0 EL0.0\n");
    refuse(ErrorCode::Refused);
    begin(Version::One);
    EXPECT_EQ(say("AZ10 EL10\n"), "");
}

TEST_F(EasycommThat, RefusesAPlaceStopsAllTheSame)
{
    static_cast<void>(say("MR\n"));
    EXPECT_EQ(say("AZ999 EL10 SA SE\n"), "ALoutside-limits\n");
    EXPECT_EQ(rotator.mover, 0U);
}

TEST_F(EasycommThat, HearsNonsenseHangsUp)
{
    std::string eight;
    for (int i = 0; i < 8; ++i) {
        eight += "nonsense\n";
    }
    const std::string replies = say(eight + "AZ10 EL10\n");
    EXPECT_EQ(replies.size(), 8 * std::string("ALnot-understood\n").size());
    EXPECT_TRUE(talk->dropped());
    EXPECT_EQ(rotator.actions, 0);
}

TEST_F(EasycommThat, HearsABrowserHangsUpWithoutAWord)
{
    EXPECT_EQ(say("POST / HTTP/1.1\r\nHost: x\r\n\r\nAZ10 EL10\n"), "");
    EXPECT_TRUE(talk->dropped());
    EXPECT_EQ(rotator.actions, 0);
}

TEST_F(EasycommThat, IsLeftForgetsHalfACommand)
{
    EXPECT_EQ(say("AZ10 EL1"), "");
    talk->endOfInput();
    EXPECT_EQ(say(""), "");
    EXPECT_FALSE(talk->ending().isEmpty());
    EXPECT_FALSE(talk->dropped());
    EXPECT_EQ(rotator.actions, 0) << "EL10 was perhaps meant";
}

TEST_F(EasycommThat, IsInTheListOfClients)
{
    static_cast<void>(say("AZ60.0 EL30.0\n"));
    EXPECT_EQ(talk->habits().lastCommand(), QStringLiteral("AZ60.0 EL30.0"));
    EXPECT_EQ(talk->habits().lastMotion(), clock.now());
    rotator.became = QStringLiteral("turns at 3.0°/s, the fastest jog rate");
    static_cast<void>(say("VL9900\n"));
    EXPECT_EQ(talk->habits().lastInWords(), QStringLiteral("VL9900 → turns at 3.0°/s, the fastest jog rate"));
    static_cast<void>(say("UP145900000\n"));
    EXPECT_EQ(talk->habits().lastInWords(), QStringLiteral("VL9900 → turns at 3.0°/s, the fastest jog rate"))
        << "the last command that acts";
}

// REQ-EASYCOMMSERVER-06: At a port an EasyComm client is served like a rotctld client: its turning ends when it
// vanishes, and the list shows its number and protocol.
TEST(EasycommPort, ServesAsTheRotctldPortDoes)
{
    fakes::ManualClock clock;
    fakes::DummyRotator rotator{clock};
    rotctld::Server server({.port = 0, .protocol = "EasyComm II", .newestClient = std::make_shared<std::uint64_t>(50)},
                           talkEasycomm(rotator, clock, Version::Two), rotator, clock);
    ASSERT_TRUE(server.listen());
    const auto turn = [] { QCoreApplication::processEvents(QEventLoop::AllEvents); };
    fakes::TcpPeer peer("127.0.0.1", server.port(), turn);
    EXPECT_EQ(peer.ask("AZ EL \n"), "AZ0.0 EL0.0\n");
    ASSERT_EQ(server.clients().size(), 1U);
    EXPECT_EQ(server.clients().front().program, "EasyComm II");
    static_cast<void>(peer.send("MR\nAZ\n"));
    EXPECT_EQ(peer.receiveLines(1), "AZ0.0\n");
    EXPECT_EQ(rotator.mover, 51U);
    peer.reset();
    while (rotator.gone.empty()) {
        turn();
    }
    EXPECT_EQ(rotator.mover, 0U) << "its turning has ended";
}

}  // namespace
}  // namespace boresight::easycomm
