// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/udp_server/n1mm_words.h"

#include <gtest/gtest.h>

#include <string>

namespace boresight::udp {
namespace {

constexpr const char* kTurn =
    "<N1MMRotor><rotor>Yagi 20</rotor><goazi>55.5</goazi><offset>0.0</offset><bidirectional>0</bidirectional>"
    "<freqband>14</freqband></N1MMRotor>";

std::optional<Angle> azimuthOf(std::string_view datagram, const std::string& rotor = {})
{
    const auto command = parseN1mm(datagram, rotor);
    const auto* const target = command ? std::get_if<Target>(&*command) : nullptr;
    return target == nullptr || target->elevation ? std::nullopt : target->azimuth;
}

template <class Wanted>
bool isN1mm(std::string_view datagram, const std::string& rotor = {})
{
    const auto command = parseN1mm(datagram, rotor);
    return command && std::holds_alternative<Wanted>(*command);
}

std::optional<ErrorCode> refusedN1mm(std::string_view datagram, const std::string& rotor = {})
{
    const auto command = parseN1mm(datagram, rotor);
    return command ? std::nullopt : std::optional(command.error().code);
}

// REQ-UDPSERVER-04 (N1mmWords.*): A datagram of N1MM Logger+ points the azimuth or stops. With a name in the line of
// the listener only datagrams for the rotor of this name count.
TEST(N1mmWords, TurnsTheAzimuth)
{
    EXPECT_EQ(azimuthOf(kTurn), 55.5_deg);
    EXPECT_EQ(azimuthOf("<?xml version=\"1.0\" encoding=\"utf-8\"?>\r\n<N1MMRotor>\r\n  <rotor>1</rotor>\r\n"
                        "  <goazi>222,5</goazi>\r\n  <offset>0,0</offset>\r\n  <bidirectional>1</bidirectional>\r\n"
                        "  <freqband>1.8</freqband>\r\n</N1MMRotor>\r\n"),
              222.5_deg);
    EXPECT_EQ(azimuthOf("<N1MMRotor><goazi>20.0</goazi><offset>0.0</offset><bidirectional>0</bidirectional>"
                        "</N1MMRotor>"),
              20_deg)
        << "N1MM before it had names";
}

TEST(N1mmWords, StopsByAnyOfItsForms)
{
    for (const char* const datagram :
         {"<N1MMRotor><stop><rotor>Yagi 20</rotor><freqband>21.0</freqband></stop></N1MMRotor>",
          "<N1MMRotor><stop>Yagi 20</stop></N1MMRotor>", "<N1MMRotor><rotor>Yagi 20</rotor><stop>1</stop></N1MMRotor>",
          "<N1MMRotor><stop></stop></N1MMRotor>", "<N1MMRotor><stop>1</stop></N1MMRotor>",
          "<N1MMRotor><stop> 0 </stop></N1MMRotor>", "<N1MMRotor><stop><freqband>21.0</freqband></stop></N1MMRotor>",
          "<N1MMRotor><stop><rotor></rotor><freqband>21.0</freqband></stop></N1MMRotor>",
          "<N1MMRotor><rotor>Yagi 20</rotor><goazi>5</goazi><stop>1</stop>", "<N1MMRotor><stop>"}) {
        EXPECT_TRUE(isN1mm<StopTurning>(datagram)) << datagram;
        EXPECT_TRUE(isN1mm<StopTurning>(datagram, "Yagi 20")) << datagram;
    }
}

TEST(N1mmWords, IsForOneRotor)
{
    EXPECT_EQ(azimuthOf(kTurn, "Yagi 20"), 55.5_deg);
    EXPECT_EQ(azimuthOf("<N1MMRotor><rotor>A &amp; B</rotor><goazi>5</goazi></N1MMRotor>", "A & B"), 5_deg);
    EXPECT_EQ(azimuthOf("<N1MMRotor><rotor>A & B</rotor><goazi>5</goazi></N1MMRotor>", "A & B"), 5_deg);
    for (const char* const other :
         {kTurn, "<N1MMRotor><goazi>20.0</goazi></N1MMRotor>",
          "<N1MMRotor><stop><rotor>Yagi 20</rotor><freqband>21.0</freqband></stop></N1MMRotor>",
          "<N1MMRotor><stop>Yagi 20</stop></N1MMRotor>"}) {
        EXPECT_TRUE(isN1mm<Nothing>(other, "Yagi 2")) << other;
    }
}

TEST(N1mmWords, NothingElseIsACommand)
{
    for (const char* const datagram :
         {"", "<stop>", "<N1MMRotor></N1MMRotor>", "<N1MMRotor><rotor>1</rotor></N1MMRotor>",
          "<N1MMRotor><goazi>5</goazi>", "<N1MMRotor><goazi></goazi></N1MMRotor>",
          "<N1MMRotor><goazi>north</goazi></N1MMRotor>", "<N1MMRotor><goazi>1e2</goazi></N1MMRotor>",
          "<N1MMRotor><goazi>nan</goazi></N1MMRotor>", "<N1MMRotor><goazi>&#53;</goazi></N1MMRotor>",
          "<N1MMRotor><goazi>1</goazi></N1MMRotor><N1MMRotor><goazi>2</goazi></N1MMRotor>",
          "<N1MMRotor><goazi>1</goazi><goazi>2</goazi></N1MMRotor>",
          "<N1MMRotor><goazi>5</goazi><el>9</el></N1MMRotor>",
          "<N1MMRotor><goazi>5</goazi><offset>x</offset></N1MMRotor>", "<RadioInfo><Freq>702500</Freq></RadioInfo>",
          "<PST><AZIMUTH>85</AZIMUTH></PST>", "\xff"}) {
        EXPECT_EQ(refusedN1mm(datagram), ErrorCode::InvalidInput) << datagram;
    }
    EXPECT_EQ(refusedN1mm("<N1MMRotor><goazi>3601</goazi></N1MMRotor>"), ErrorCode::OutOfRange);
    EXPECT_EQ(refusedN1mm("<N1MMRotor><goazi>5</goazi><offset>90.0</offset></N1MMRotor>"), ErrorCode::NotAvailable)
        << "programs differ in what it means";
}

}  // namespace
}  // namespace boresight::udp
