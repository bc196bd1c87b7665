// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/udp_server/udp_controller.h"

#include "core/udp_server/n1mm_words.h"
#include "core/udp_server/pst_words.h"
#include "tests/fakes/dummy_rotator.h"
#include "tests/fakes/manual_clock.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>

namespace boresight::udp {
namespace {

using namespace std::chrono_literals;

std::string azimuthDatagram(const std::string& degrees)
{
    return "<PST><AZIMUTH>" + degrees + "</AZIMUTH></PST>";
}

struct UdpControllerTest : ::testing::Test
{
    [[nodiscard]] UdpController meet(std::uint64_t id)
    {
        return {{.id = id, .address = "127.0.0.1:5", .protocol = "PstRotator"},
                {.rotator = rotator, .parse = parse, .settling = settling, .clock = clock}};
    }
    std::string pst(const std::string& datagram) { return first.obey(datagram).reply; }

    fakes::ManualClock clock;
    fakes::DummyRotator rotator{clock};
    Parse parse = parsePst;
    rotctld::Settling settling{clock};
    UdpController first = meet(7);
    UdpController second = meet(8);
};

// REQ-UDPSERVER-05 (UdpControllerTest.*): Clients point, stop, park and read the mount by the same requests as rotctld
// clients. Only questions are answered, and not while there is no position.
TEST_F(UdpControllerTest, PointsReadsAndParks)
{
    EXPECT_EQ(pst("<PST><AZIMUTH>120.5</AZIMUTH><ELEVATION>30</ELEVATION></PST>"), "");
    clock.advance(1s);
    EXPECT_EQ(pst("<PST>AZ?</PST>"), "AZ:6.0\r");
    EXPECT_EQ(pst("<PST>TGA?</PST>"), "TGA:120.5\r");
    clock.advance(30s);
    EXPECT_EQ(pst("<PST>AZ?</PST>"), "AZ:120.5\r");
    EXPECT_EQ(pst("<PST>EL?</PST>"), "EL:30.0\r");
    EXPECT_EQ(pst("<PST><PARK>1</PARK></PST>"), "");
    clock.advance(30s);
    EXPECT_EQ(pst("<PST>AZ?</PST>"), "AZ:0.0\r");
}

TEST_F(UdpControllerTest, OneAxisLeavesTheOtherAtItsTarget)
{
    rotator.sag = 0.3_deg;
    EXPECT_EQ(pst("<PST><AZIMUTH>10</AZIMUTH><ELEVATION>30</ELEVATION></PST>"), "");
    clock.advance(30s);
    for (const char* const degrees : {"20", "30", "40"}) {
        static_cast<void>(pst(azimuthDatagram(degrees)));
        clock.advance(30s);
        EXPECT_EQ(rotator.lastRequest->elevation, 30_deg) << "it does not creep down";
    }
    static_cast<void>(rotator.stop({.id = 3, .address = {}}));
    static_cast<void>(pst(azimuthDatagram("50")));
    EXPECT_EQ(rotator.lastRequest->elevation, 30_deg) << "after a stop too";
}

TEST_F(UdpControllerTest, ClientsShareTheTarget)
{
    rotator.sag = 0.3_deg;
    EXPECT_EQ(pst("<PST><AZIMUTH>10</AZIMUTH><ELEVATION>30</ELEVATION></PST>"), "");
    clock.advance(30s);
    EXPECT_TRUE(second.obey(azimuthDatagram("20")).result);
    EXPECT_EQ(rotator.lastRequest->elevation, 30_deg);
    rotator.clientGone({.id = 7, .address = {}}, {});
    rotator.clientGone({.id = 8, .address = {}}, {});
    EXPECT_TRUE(meet(9).obey(azimuthDatagram("30")).result);
    EXPECT_EQ(rotator.lastRequest->elevation, 30_deg) << "the host sends again after a silence";
}

TEST_F(UdpControllerTest, StopsOnItsWay)
{
    EXPECT_EQ(pst("<PST><AZIMUTH>100</AZIMUTH><ELEVATION>30</ELEVATION></PST>"), "");
    clock.advance(1s);
    EXPECT_EQ(pst("<PST><STOP>1</STOP><AZIMUTH>200</AZIMUTH></PST>"), "");
    clock.advance(30s);
    EXPECT_EQ(pst("<PST>AZ?</PST>"), "AZ:6.0\r");
    EXPECT_EQ(pst("<PST>TGA?</PST>"), "TGA:6.0\r");
}

TEST_F(UdpControllerTest, N1mmTurnsOnlyTheAzimuth)
{
    parse = [](std::string_view datagram) { return parseN1mm(datagram, "Yagi 20"); };
    UdpController n1mm = meet(9);
    const std::string turn = "<N1MMRotor><rotor>Yagi 20</rotor><goazi>-10.0</goazi><offset>0.0</offset></N1MMRotor>";
    const rotctld::LineOutcome outcome = n1mm.obey(turn);
    EXPECT_TRUE(outcome.result && outcome.motion && outcome.reply.empty());
    EXPECT_EQ(rotator.lastRequest->azimuth, -10_deg);
    const int before = rotator.actions;
    const rotctld::LineOutcome other = n1mm.obey("<N1MMRotor><rotor>Beam</rotor><goazi>50.0</goazi></N1MMRotor>");
    EXPECT_TRUE(other.result && !other.motion);
    EXPECT_EQ(other.became, QStringLiteral("for the rotor \"Beam\""));
    EXPECT_EQ(n1mm.obey("<N1MMRotor><goazi>50.0</goazi></N1MMRotor>").became, QStringLiteral("names no rotor"));
    EXPECT_EQ(rotator.actions, before);
}

// REQ-UDPSERVER-12: A motion that arrives within 2 s after a time in which nobody read is refused and logged, because
// it may be old. Questions are answered, and a stop is obeyed.
TEST_F(UdpControllerTest, MovesNothingWhileACommandMayBeOld)
{
    clock.sleep(30min);
    settling.tick();
    for (const char* const motion : {"<PST><AZIMUTH>10</AZIMUTH></PST>", "<PST><PARK>1</PARK></PST>"}) {
        const rotctld::LineOutcome outcome = first.obey(motion);
        ASSERT_FALSE(outcome.result) << motion;
        EXPECT_EQ(outcome.result.error().code, ErrorCode::Refused) << motion;
    }
    EXPECT_EQ(rotator.actions, 0);
    ASSERT_EQ(rotator.remarks.size(), 2U);
    EXPECT_TRUE(
        rotator.remarks[0].ends_with("This computer slept or was blocked less than 2 s ago. The command may be "
                                     "old. Send it again."))
        << rotator.remarks[0];
    EXPECT_EQ(pst("<PST>AZ?</PST>"), "AZ:0.0\r");
    EXPECT_TRUE(first.obey("<PST><STOP>1</STOP></PST>").result);
    EXPECT_EQ(rotator.actions, 1);
    clock.advance(2s);
    EXPECT_TRUE(first.obey(azimuthDatagram("10")).result);
}

// REQ-UDPSERVER-16: Of the motions of a host in one second 20 are obeyed. The others are refused, and the first of them
// is logged. Questions and stops are not counted.
TEST_F(UdpControllerTest, BearsAFloodOfMotions)
{
    for (int i = 0; i < 1000; ++i) {
        static_cast<void>(first.obey(azimuthDatagram("10")));
        static_cast<void>(first.obey("<PST><TRACK>0</TRACK></PST>"));
    }
    EXPECT_EQ(rotator.actions, 20);
    ASSERT_EQ(rotator.remarks.size(), 1U);
    EXPECT_TRUE(
        rotator.remarks[0].ends_with("More than 20 commands arrived in one second. Boresight ignores the rest."));
    EXPECT_EQ(first.obey("<PST><PARK>1</PARK></PST>").result.error().code, ErrorCode::Busy);
    EXPECT_TRUE(second.obey(azimuthDatagram("20")).result) << "another host";
    for (int i = 0; i < 100; ++i) {
        EXPECT_TRUE(first.obey("<PST><STOP>1</STOP></PST>").result);
        EXPECT_EQ(pst("<PST>AZ?</PST>"), "AZ:0.0\r");
    }
    EXPECT_EQ(rotator.actions, 121);
    clock.advance(1s);
    EXPECT_TRUE(first.obey(azimuthDatagram("30")).result);
}

// REQ-UDPSERVER-02
TEST_F(UdpControllerTest, AStopIsObeyedHoweverLongItsDatagram)
{
    const std::string blanks(UdpController::kLongest, ' ');
    EXPECT_FALSE(first.obey("<PST><AZIMUTH>10</AZIMUTH></PST>" + blanks).result);
    EXPECT_EQ(rotator.actions, 0);
    EXPECT_TRUE(first.obey("<PST><STOP>1</STOP>" + blanks).result);
    EXPECT_EQ(rotator.actions, 1);
}

// REQ-UDPSERVER-15: The log has the reason of each refused command. The rotator logs what it refuses itself.
TEST_F(UdpControllerTest, WhatIsRefusedIsLogged)
{
    EXPECT_FALSE(first.obey("<PST><AZIMUTH>999</AZIMUTH></PST>").result) << "outside the limits";
    EXPECT_TRUE(rotator.remarks.empty()) << "the rotator has refused it";
    for (const char* const datagram : {"nonsense", "<PST><AZIMUTH>3601</AZIMUTH></PST>", "<PST><AZIMUTH>1</AZIMUTH>",
                                       "<PST><QRA>KN34BJ</QRA></PST>"}) {
        EXPECT_FALSE(first.obey(datagram).result) << datagram;
        EXPECT_TRUE(rotator.remarks.back().starts_with("\"" + std::string(datagram).substr(0, 12))) << datagram;
    }
    EXPECT_FALSE(first.obey(std::string(UdpController::kLongest, 'x') + "y").result);
    EXPECT_TRUE(rotator.remarks.back().ends_with("A datagram has at most 512 bytes.")) << rotator.remarks.back();
    EXPECT_EQ(rotator.remarks.size(), 5U);
    rotator.fault = Error{.code = ErrorCode::NoAnswer, .text = QStringLiteral("the drives are silent")};
    EXPECT_EQ(pst("<PST>AZ?</PST>"), "") << "a program asks often";
    EXPECT_EQ(rotator.remarks.size(), 5U);
    EXPECT_FALSE(first.obey(azimuthDatagram("50")).result);
    EXPECT_EQ(rotator.remarks.back(), "\"<PST><AZIMUTH>50</AZIMUTH></PST>\" refused: the drives are silent");
    EXPECT_FALSE(first.obey("<PST><PARK>1</PARK></PST>").result);
    EXPECT_EQ(rotator.remarks.size(), 6U) << "the rotator has refused it";
}

TEST_F(UdpControllerTest, WhatIsRefusedIsNotAnswered)
{
    rotator.fault = Error{.code = ErrorCode::NoAnswer, .text = QStringLiteral("the drives are silent")};
    const int before = rotator.actions;
    for (const char* const datagram : {"<PST>AZ?</PST>", "<PST>EL?</PST>", "<PST>TGA?</PST>"}) {
        const rotctld::LineOutcome outcome = first.obey(datagram);
        EXPECT_FALSE(outcome.result) << datagram;
        EXPECT_EQ(outcome.reply, "") << datagram;
    }
    EXPECT_FALSE(first.obey(azimuthDatagram("50")).result) << "without a position the elevation is unknown";
    EXPECT_EQ(rotator.actions, before);
}

}  // namespace
}  // namespace boresight::udp
