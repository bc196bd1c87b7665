// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/udp_server/pst_words.h"

#include <gtest/gtest.h>

#include <string>

namespace boresight::udp {
namespace {

template <class Wanted>
std::optional<Wanted> pst(std::string_view datagram)
{
    const auto command = parsePst(datagram);
    const auto* const wanted = command ? std::get_if<Wanted>(&*command) : nullptr;
    return wanted == nullptr ? std::nullopt : std::optional(*wanted);
}

std::optional<ErrorCode> refusedPst(std::string_view datagram)
{
    const auto command = parsePst(datagram);
    return command ? std::nullopt : std::optional(command.error().code);
}

// "85 30", "- 30" without an azimuth.
std::string anglesOf(std::string_view datagram)
{
    const auto target = pst<Target>(datagram);
    const auto text = [](const std::optional<Angle>& angle) {
        return angle ? QString::number(angle->degrees(), 'g', 9).toStdString() : std::string("-");
    };
    return target ? text(target->azimuth) + " " + text(target->elevation) : "none";
}

// REQ-UDPSERVER-01 (PstWords.*): A datagram for PstRotator points one axis or both, stops, parks or asks for azimuth,
// elevation or target azimuth. Numbers may have a decimal comma, and the ".2" that Hamlib 4.6 writes at their end.
TEST(PstWords, PointsOneAxisOrBoth)
{
    EXPECT_EQ(anglesOf("<PST><AZIMUTH>85</AZIMUTH></PST>"), "85 -");
    EXPECT_EQ(anglesOf("<PST><ELEVATION>25.5</ELEVATION></PST>\n"), "- 25.5");
    EXPECT_EQ(anglesOf("<PST><AZIMUTH>200</AZIMUTH><ELEVATION>45</ELEVATION></PST>"), "200 45");
    EXPECT_EQ(anglesOf("<PST><AZIMUTH>123,4</AZIMUTH></PST>\r\n"), "123.4 -");
    EXPECT_EQ(anglesOf("<PST><AZIMUTH>360.0</AZIMUTH></PST>"), "360 -");
    EXPECT_EQ(anglesOf("<pst><azimuth> -5 </azimuth></pst>"), "-5 -");
    EXPECT_EQ(anglesOf("<?xml version=\"1.0\"?><PST><AZIMUTH>85</AZIMUTH></PST>"), "85 -");
}

// What programs send, as it is on the wire.
TEST(PstWords, ReadsWhatProgramsSend)
{
    EXPECT_EQ(anglesOf("<PST><AZIMUTH>20.000000.2</AZIMUTH></PST>"), "20 -") << "Hamlib 4.6";
    EXPECT_EQ(anglesOf("<PST><ELEVATION>15.250000.2</ELEVATION></PST>"), "- 15.25") << "Hamlib 4.6";
    EXPECT_EQ(anglesOf("<PST><AZIMUTH>85,000000.2</AZIMUTH></PST>"), "85 -") << "Hamlib 4.6 in a German locale";
    EXPECT_EQ(anglesOf("<PST><TRACK>0</TRACK><AZIMUTH>123.4</AZIMUTH><ELEVATION>5.6</ELEVATION></PST>"), "123.4 5.6")
        << "Project Horus";
    EXPECT_EQ(pst<Ask>("<PST>AZ?</PST>"), Ask::Azimuth);
    EXPECT_EQ(pst<Ask>("<PST>EL?</PST>\n"), Ask::Elevation);
    EXPECT_EQ(pst<Ask>("<PST>TGA?</PST>"), Ask::TargetAzimuth);
    EXPECT_TRUE(pst<Park>("<PST><PARK>1</PARK></PST>"));
    EXPECT_TRUE(pst<Nothing>("<PST><TRACK>0</TRACK></PST>"));
}

// REQ-UDPSERVER-02: A stop counts in any datagram, whatever else stands there.
TEST(PstWords, AStopCountsInAnyDatagram)
{
    for (const char* const datagram :
         {"<PST><STOP>1</STOP></PST>", "<PST><STOP> 1 </STOP></PST>", "<PST><STOP>1</STOP><AZIMUTH>85</AZIMUTH></PST>",
          "<PST><AZIMUTH>85</AZIMUTH><STOP>1</STOP></PST>", "<PST><PARK>1</PARK><STOP>1</STOP></PST>",
          "<PST><FOO>2</FOO><STOP>1</STOP>", "<STOP>1</STOP>", "x<STOP>\t1\r\n</STOP>",
          "<STOP>0</STOP><STOP><STOP>1<STOP> 1 </STOP>"}) {
        EXPECT_TRUE(pst<StopTurning>(datagram)) << datagram;
    }
}

// REQ-UDPSERVER-03 (PstWords.Nothing*, N1mmWords.Nothing*): A datagram that is incomplete, invalid, out of reach or of
// another protocol moves nothing.
TEST(PstWords, NothingElseIsACommand)
{
    for (const char* const datagram : {"",
                                       "AZ?",
                                       "<PST></PST>",
                                       "<PST>85</PST>",
                                       "<PST><AZIMUTH></AZIMUTH></PST>",
                                       "<PST><AZIMUTH>85</AZIMUTH>",
                                       "<PST><AZIMUTH>85</AZIMUTH></PST>x",
                                       "<PST><AZIMUTH>north</AZIMUTH></PST>",
                                       "<PST><AZIMUTH>1e2</AZIMUTH></PST>",
                                       "<PST><AZIMUTH>nan</AZIMUTH></PST>",
                                       "<PST><AZIMUTH>inf</AZIMUTH></PST>",
                                       "<PST><AZIMUTH>&#56;5</AZIMUTH></PST>",
                                       "<!DOCTYPE a [<!ENTITY x \"85\">]><PST><AZIMUTH>&x;</AZIMUTH></PST>",
                                       "<PST><AZIMUTH><![CDATA[85]]></AZIMUTH></PST>",
                                       "<PST><AZIMUTH unit=\"deg\">85</AZIMUTH></PST>",
                                       "<PST><AZIMUTH>1</AZIMUTH></PST><PST><AZIMUTH>2</AZIMUTH></PST>",
                                       "<PST><AZIMUTH>85.0.2</AZIMUTH></PST>",
                                       "<PST><AZIMUTH>85.000000.3</AZIMUTH></PST>",
                                       "<PST><AZIMUTH>1</AZIMUTH><AZIMUTH>2</AZIMUTH></PST>",
                                       "<PST><AZIMUTH>1</AZIMUTH><EVATION>2</EVATION></PST>",
                                       "<PST><AZIMUTH>1</AZIMUTH><PARK>1</PARK></PST>",
                                       "<PST><TRACK>1</TRACK></PST>",
                                       "<PST><TRACK>85.0 30.0</TRACK></PST>",
                                       "<PST><PARK>0</PARK></PST>",
                                       "<PST><STOP>0</STOP></PST>",
                                       "<PST><STOP>1<x></STOP></PST>",
                                       "<PST><STOP>11</STOP></PST>",
                                       "<STOP>1",
                                       "<STOP>1</STOP",
                                       "<PST><QRA>KN34BJ</QRA></PST>",
                                       "<PST>AZ?EL?</PST>",
                                       "<N1MMRotor><goazi>20.0</goazi></N1MMRotor>",
                                       "P 10 20",
                                       "\x80"}) {
        EXPECT_EQ(refusedPst(datagram), ErrorCode::InvalidInput) << datagram;
    }
    EXPECT_EQ(refusedPst("<PST><AZIMUTH>3601</AZIMUTH></PST>"), ErrorCode::OutOfRange);
    EXPECT_EQ(refusedPst("<PST><ELEVATION>180.1</ELEVATION></PST>"), ErrorCode::OutOfRange);
    EXPECT_EQ(refusedPst("<PST><ELEVATION>-91</ELEVATION></PST>"), ErrorCode::OutOfRange);
}

TEST(PstWords, ARefusalNamesTheField)
{
    const auto reasonOf = [](std::string_view datagram) { return parsePst(datagram).error().text.toStdString(); };
    EXPECT_EQ(reasonOf("<PST><AZIMUTH>1</AZIMUTH><QRA>KN34BJ</QRA></PST>"),
              "Boresight does not obey the field \"QRA\" with the value \"KN34BJ\".");
    EXPECT_EQ(reasonOf("<PST><ELEVATION>up</ELEVATION></PST>"),
              "Boresight does not obey the field \"ELEVATION\" with the value \"UP\".");
    EXPECT_EQ(reasonOf("<PST><PARK>1</PARK><PARK>1</PARK></PST>"), "The datagram has the field \"PARK\" twice.");
    EXPECT_EQ(reasonOf("<PST>AZ?EL?</PST>"), "This is no datagram for PstRotator.");
}

TEST(PstWords, AnswersAsPstRotatorDoes)
{
    const SkyPointing place{.azimuth = -90.06_deg, .elevation = -0.04_deg};
    EXPECT_EQ(pstAnswer(Ask::Azimuth, place), "AZ:269.9\r");
    EXPECT_EQ(pstAnswer(Ask::Elevation, place), "EL:0.0\r");
    EXPECT_EQ(pstAnswer(Ask::TargetAzimuth, {.azimuth = 450_deg, .elevation = 0_deg}), "TGA:90.0\r");
}

}  // namespace
}  // namespace boresight::udp
