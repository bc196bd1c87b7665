// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/easycomm_server/easycomm_words.h"

#include <gtest/gtest.h>

#include <string>

namespace boresight::easycomm {
namespace {

using rotctld::MoveDirection;

// The only command in a line, apart from those for a radio.
template <class Wanted>
std::optional<Wanted> parsed(std::string_view line, Version version = Version::Two)
{
    auto commands = parseLine(line, version);
    while (commands && commands->size() > 1 && std::holds_alternative<NotForARotator>(commands->back())) {
        commands->pop_back();
    }
    const auto* const wanted = commands && commands->size() == 1 ? std::get_if<Wanted>(&commands->front()) : nullptr;
    return wanted == nullptr ? std::nullopt : std::optional(*wanted);
}

std::optional<ErrorCode> refused(std::string_view line, Version version = Version::Three)
{
    const auto commands = parseLine(line, version);
    return commands ? std::nullopt : std::optional(commands.error().code);
}

void expectTarget(std::string_view line, std::optional<double> azimuth, std::optional<double> elevation)
{
    const auto target = parsed<Target>(line, Version::One);
    ASSERT_TRUE(target) << line;
    ASSERT_EQ(target->azimuth.has_value(), azimuth.has_value()) << line;
    ASSERT_EQ(target->elevation.has_value(), elevation.has_value()) << line;
    EXPECT_NEAR(target->azimuth.value_or(Angle{}).degrees(), azimuth.value_or(0.0), 1e-9) << line;
    EXPECT_NEAR(target->elevation.value_or(Angle{}).degrees(), elevation.value_or(0.0), 1e-9) << line;
}

// REQ-EASYCOMMSERVER-01 (EasycommWords.*): A line of EasyComm I, II or III is read as in the standard: commands of two
// letters, separated by blanks. An azimuth and an elevation together are one target. A command without its number is a
// query. Positions are answered in tenths of a degree.
TEST(EasycommWords, APlaceIsAnAzimuthAndAnElevation)
{
    expectTarget("AZ123.4 EL45.6", 123.4, 45.6);
    expectTarget("AZ123.4 EL45.6 UP000 XXX DN000 XXX", 123.4, 45.6);
    expectTarget("EL45.6 AZ123.4", 123.4, 45.6);
    expectTarget(" az0.0  el-5.0 ", 0.0, -5.0);
    expectTarget("AZ370 EL180", 370.0, 180.0);
    expectTarget("AZ+12.25\tEL7,5", 12.25, 7.5);
    expectTarget("AZ123.4", 123.4, std::nullopt);
    expectTarget("EL45.6 ", std::nullopt, 45.6);
}

TEST(EasycommWords, WithoutANumberTheyAreQuestions)
{
    EXPECT_EQ(parsed<Ask>("AZ", Version::One), Ask::Azimuth);
    EXPECT_EQ(parsed<Ask>("EL"), Ask::Elevation);
    EXPECT_EQ(parsed<Ask>(";AZ"), Ask::Azimuth) << "what Hamlib leaves of the question before";
    const auto both = parseLine("AZ EL ", Version::Two);
    ASSERT_TRUE(both && both->size() == 2);
    EXPECT_EQ(std::get<Ask>((*both)[0]), Ask::Azimuth);
    EXPECT_EQ(std::get<Ask>((*both)[1]), Ask::Elevation);
    EXPECT_EQ(parsed<Ask>("VE"), Ask::Version);
    EXPECT_EQ(parsed<Ask>("GS", Version::Three), Ask::Status);
    EXPECT_EQ(parsed<Ask>("GE", Version::Three), Ask::Errors);
}

TEST(EasycommWords, TheyTurnStopAndPark)
{
    for (const auto& [line, direction] : {std::pair("ML", MoveDirection::Left), std::pair("MR", MoveDirection::Right),
                                          std::pair("MU", MoveDirection::Up), std::pair("md", MoveDirection::Down)}) {
        const auto turn = parsed<Turn>(line);
        ASSERT_TRUE(turn) << line;
        EXPECT_EQ(turn->direction, direction) << line;
        EXPECT_FALSE(turn->rate) << line;
    }
    for (const auto& [line, direction] :
         {std::pair("VL0500", MoveDirection::Left), std::pair("VR0500", MoveDirection::Right),
          std::pair("VU500", MoveDirection::Up), std::pair("VD00500", MoveDirection::Down)}) {
        const auto turn = parsed<Turn>(line, Version::Three);
        ASSERT_TRUE(turn && turn->rate) << line;
        EXPECT_EQ(turn->direction, direction) << line;
        EXPECT_NEAR(turn->rate->degrees(), 0.5, 1e-12) << line;
    }
    for (const char* const line : {"SA", "SE", "STOP"}) {
        EXPECT_TRUE(parsed<StopTurning>(line, Version::One)) << line;
    }
    const auto stops = parseLine("SA SE ", Version::One);
    ASSERT_TRUE(stops);
    EXPECT_EQ(stops->size(), 2U);
    const auto still = parsed<Turn>("VL0000", Version::Three);
    ASSERT_TRUE(still && still->rate);
    EXPECT_EQ(*still->rate, AngularRate{});
    EXPECT_TRUE(parsed<Park>("PARK"));
    EXPECT_TRUE(parsed<Reset>("RESET"));
}

TEST(EasycommWords, WhatIsForTheRadioIsNoMotion)
{
    for (const char* const line : {"UP145900000", "DN435000000", "UMFM", "DMSSB", "UR1", "DR2", "AO", "LO",
                                   "ST26:11:28:20:00:00", "OP1,1", "UP145900000 FM", "DN000 CW"}) {
        EXPECT_TRUE(parsed<NotForARotator>(line)) << line;
    }
    const auto both = parseLine("UP145900000 AZ", Version::Two);
    ASSERT_TRUE(both && both->size() == 2) << "a question is no mode";
}

// REQ-EASYCOMMSERVER-02 (EasycommWords.Nothing*, EasycommThat.*): Text that is incomplete, invalid, too long or of
// another protocol moves nothing. Neither do commands for registers and inputs. A line is obeyed completely or not at
// all.
TEST(EasycommWords, NothingElseIsACommand)
{
    for (const char* const line : {"A",
                                   "STOPP",
                                   "AZ123.4EL45.6",
                                   "AZ 123.4",
                                   "AZ123.4 45.6",
                                   "AZ123.4.5",
                                   "AZ1e2",
                                   "AZ0x10",
                                   "AZnan",
                                   "AZinf",
                                   "AZ--5",
                                   "AZ,",
                                   "AZ123.4 EL45.6 xyz",
                                   "AZ123.4 SA SX",
                                   "AZ10 AZ20",
                                   "AZ10 EL20 ML",
                                   "ML MR",
                                   "PARK AZ10",
                                   "ML5",
                                   "VL",
                                   "VL-500",
                                   "VL0.5",
                                   "VL1234567",
                                   "VX0500",
                                   "PARKED",
                                   "RESETS",
                                   "W123 045",
                                   "C2",
                                   "P 123 45",
                                   "\\get_pos",
                                   "GET / HTTP/1.1",
                                   "\x80",
                                   "AZ\xd9\xa1\xd9\xa2"}) {
        EXPECT_EQ(refused(line), ErrorCode::InvalidInput) << line;
    }
    std::string many = "SA";
    for (int i = 0; i < 16; ++i) {
        many += " SA";
    }
    EXPECT_EQ(refused(many), ErrorCode::InvalidInput);
    for (const char* const line : {"AZ3601", "AZ-3601 EL0", "EL-90.1", "AZ10 EL180.1", "EL999999999999"}) {
        EXPECT_EQ(refused(line), ErrorCode::OutOfRange) << line;
    }
    for (const char* const line : {"CR 0", "CR0", "CW0,5000", "IP1", "AN3", "AZ10 EL10 IP1"}) {
        EXPECT_EQ(refused(line), ErrorCode::NotAvailable) << line;
    }
}

TEST(EasycommWords, NothingOfALaterVersionIsKnownToAnEarlierOne)
{
    for (const char* const line : {"ML", "MD", "PARK", "RESET", "VE", "GS", "VU0100"}) {
        EXPECT_EQ(refused(line, Version::One), ErrorCode::InvalidInput) << line;
    }
    for (const char* const line : {"GS", "GE", "VU0100"}) {
        EXPECT_EQ(refused(line, Version::Two), ErrorCode::InvalidInput) << line;
    }
}

TEST(EasycommWords, PositionsAreInTenths)
{
    EXPECT_EQ(azimuthAnswer(123.44_deg), "AZ123.4");
    EXPECT_EQ(azimuthAnswer(-0.04_deg), "AZ0.0");
    EXPECT_EQ(azimuthAnswer(-90_deg), "AZ-90.0");
    EXPECT_EQ(elevationAnswer(5.67_deg), "EL5.7");
    EXPECT_EQ(elevationAnswer(-1.25_deg), "EL-1.2");
}

// An alarm contains no blank, because a blank ends a command.
TEST(EasycommWords, EachRefusalIsAnAlarm)
{
    const auto said = [](ErrorCode code) { return alarmOf({.code = code, .text = QStringLiteral("à la carte")}); };
    EXPECT_EQ(said(ErrorCode::InvalidInput), "ALnot-understood");
    EXPECT_EQ(said(ErrorCode::OutOfRange), "ALoutside-limits");
    EXPECT_EQ(said(ErrorCode::NotAvailable), "ALnot-supported");
    EXPECT_EQ(said(ErrorCode::Refused), "ALrefused");
    EXPECT_EQ(said(ErrorCode::Busy), "ALrefused");
    EXPECT_EQ(said(ErrorCode::NoAnswer), "ALno-position");
    EXPECT_EQ(said(ErrorCode::NoDevice), "ALno-position");
}

}  // namespace
}  // namespace boresight::easycomm
