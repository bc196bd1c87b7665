// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232_server/client_words.h"

#include <gtest/gtest.h>

#include <string>

namespace boresight::gs232 {
namespace {

using rotctld::MoveDirection;

template <class Wanted>
std::optional<Wanted> parsed(std::string_view line)
{
    const auto command = parseCommand(line);
    const auto* const wanted = command ? std::get_if<Wanted>(&*command) : nullptr;
    return wanted == nullptr ? std::nullopt : std::optional(*wanted);
}

std::optional<ErrorCode> refused(std::string_view line)
{
    const auto command = parseCommand(line);
    return command ? std::nullopt : std::optional(command.error().code);
}

std::string said(Ask question, double azimuth, double elevation, Dialect dialect)
{
    const SkyPointing place{.azimuth = Angle::fromDegrees(azimuth), .elevation = Angle::fromDegrees(elevation)};
    return answerTo(question, place, dialect).value_or("refused");
}

// REQ-GS232SERVER-01 (Gs232ClientWords.*): The commands for a GS-232 control box are read as the box reads them: whole
// lines, three digits, upper or lower case. Positions are answered as by the GS-232A or the GS-232B, in whole degrees.
TEST(Gs232ClientWords, AreReadAsTheBoxReadsThem)
{
    EXPECT_EQ(parsed<Ask>("C"), Ask::Azimuth);
    EXPECT_EQ(parsed<Ask>("B"), Ask::Elevation);
    EXPECT_EQ(parsed<Ask>("C2"), Ask::Both);
    EXPECT_EQ(parsed<Ask>("c2"), Ask::Both);
    const auto both = parsed<PointTo>("W123 046");
    ASSERT_TRUE(both && both->elevation);
    EXPECT_EQ(both->azimuth, 123_deg);
    EXPECT_EQ(*both->elevation, 46_deg);
    const auto azimuth = parsed<PointTo>("m450");
    ASSERT_TRUE(azimuth);
    EXPECT_EQ(azimuth->azimuth, 450_deg);
    EXPECT_FALSE(azimuth->elevation);
    for (const auto& [line, direction] : {std::pair("R", MoveDirection::Right), std::pair("L", MoveDirection::Left),
                                          std::pair("U", MoveDirection::Up), std::pair("d", MoveDirection::Down)}) {
        const auto turn = parsed<Turn>(line);
        ASSERT_TRUE(turn) << line;
        EXPECT_EQ(turn->direction, direction) << line;
    }
    for (const char* const line : {"S", "A", "E", "s"}) {
        EXPECT_TRUE(parsed<StopTurning>(line)) << line;
    }
    for (int level = 1; level <= 4; ++level) {
        const auto speed = parsed<Speed>("X" + std::to_string(level));
        ASSERT_TRUE(speed);
        EXPECT_EQ(speed->level, level);
    }
}

// REQ-GS232SERVER-02 (Gs232ClientWords.Nothing*, EmulatedBoxThat.*): Text that is incomplete, invalid, too long or of
// another protocol is answered with `?>` and moves nothing. So are lists with times, calibration, and commands that
// change the counting of the box.
TEST(Gs232ClientWords, NothingElseIsACommand)
{
    for (const char* const line : {"W",         "W123",       "W123 ",
                                   "W12 045",   "W1234 045",  "W123  045",
                                   "W123,045",  "W123 045 ",  " W123 045",
                                   "W-10 020",  "W123.4 045", "Wabc def",
                                   "M",         "M12",        "M1234",
                                   "M 123",     "M+12",       "X",
                                   "X0",        "X5",         "C3",
                                   "CC",        "SS",         "STOP",
                                   "P",         "AZ EL",      "AZ123.4 EL45.6",
                                   "\\get_pos", "p",          "GET / HTTP/1.1",
                                   "R50",       "\x80",       "W\xd9\xa1\xd9\xa2"}) {
        EXPECT_EQ(refused(line), ErrorCode::InvalidInput) << line;
    }
    for (const char* const line : {"W451 000", "W000 181", "W999 999", "M451"}) {
        EXPECT_EQ(refused(line), ErrorCode::OutOfRange) << line;
    }
    for (const char* const line : {"M010 123 045", "W010 123 045", "W010 123 045 130 050", "T", "N", "O", "O2", "F",
                                   "F2", "P36", "P45", "Z", "H", "h2"}) {
        EXPECT_EQ(refused(line), ErrorCode::NotAvailable) << line;
    }
}

TEST(Gs232ClientWords, PositionsAreGoldenBytes)
{
    EXPECT_EQ(said(Ask::Both, 180.0, 90.0, Dialect::A), "+0180+0090\r\n");
    EXPECT_EQ(said(Ask::Azimuth, 7.4, 90.0, Dialect::A), "+0007\r\n");
    EXPECT_EQ(said(Ask::Elevation, 7.4, 5.6, Dialect::A), "+0006\r\n");
    EXPECT_EQ(said(Ask::Both, 180.0, 90.0, Dialect::B), "AZ=180  EL=090\r\n");
    EXPECT_EQ(said(Ask::Azimuth, 7.4, 90.0, Dialect::B), "AZ=007\r\n");
    EXPECT_EQ(said(Ask::Elevation, 7.4, 5.6, Dialect::B), "EL=006\r\n");
    EXPECT_EQ(said(Ask::Both, 359.6, -0.4, Dialect::A), "+0360+0000\r\n");
    EXPECT_EQ(said(Ask::Both, 449.6, 180.0, Dialect::A), "+0450+0180\r\n");
    // Below 0° and above 450° the azimuth is given as the equal direction.
    EXPECT_EQ(said(Ask::Both, -90.0, 20.0, Dialect::B), "AZ=270  EL=020\r\n");
    EXPECT_EQ(said(Ask::Both, 460.0, 20.0, Dialect::B), "AZ=100  EL=020\r\n");
}

// A wrong number is never answered.
TEST(Gs232ClientWords, APlaceWithoutANumberIsNotClipped)
{
    EXPECT_EQ(said(Ask::Both, 10.0, -3.0, Dialect::A), "refused");
    EXPECT_EQ(said(Ask::Elevation, 10.0, 181.0, Dialect::B), "refused");
    EXPECT_EQ(said(Ask::Azimuth, 10.0, -3.0, Dialect::A), "+0010\r\n") << "the azimuth is known";
}

}  // namespace
}  // namespace boresight::gs232
