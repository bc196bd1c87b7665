// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pairs_server/pairs_words.h"

#include <gtest/gtest.h>

#include <string>

namespace boresight::pairs {
namespace {

template <class Wanted>
std::optional<Wanted> parsed(std::string_view line)
{
    const auto command = parseLine(line);
    const auto* const wanted = command ? std::get_if<Wanted>(&*command) : nullptr;
    return wanted == nullptr ? std::nullopt : std::optional(*wanted);
}

std::optional<ErrorCode> refused(std::string_view line)
{
    const auto command = parseLine(line);
    return command ? std::nullopt : std::optional(command.error().code);
}

// REQ-PAIRSSERVER-01 (PairsWords.*): A line is an elevation, an azimuth and an elevation, a move by an angle, a bearing
// to a locator by the short or the long path, a stop, a park or a query. A plus sign makes a line a move by an angle.
TEST(PairsWords, OneNumberIsAnElevationAndTwoAreAPlace)
{
    const auto elevation = parsed<Place>("60");
    ASSERT_TRUE(elevation);
    EXPECT_FALSE(elevation->azimuth);
    EXPECT_EQ(elevation->elevation, 60_deg);
    const auto below = parsed<Place>("-3.5");
    ASSERT_TRUE(below) << "without a plus sign it is no move";
    EXPECT_NEAR(below->elevation.degrees(), -3.5, 1e-9);
    const auto both = parsed<Place>(" 120.5\t30 ");
    ASSERT_TRUE(both && both->azimuth);
    EXPECT_NEAR(both->azimuth->degrees(), 120.5, 1e-9);
    EXPECT_EQ(both->elevation, 30_deg);
    const auto west = parsed<Place>("-90 -3");
    ASSERT_TRUE(west && west->azimuth);
    EXPECT_EQ(*west->azimuth, -90_deg);
}

const rotctld::Limits kAll{.minAzimuth = 0_deg, .maxAzimuth = 360_deg, .minElevation = 0_deg, .maxElevation = 90_deg};

TEST(PairsWords, APlusSignIsAMove)
{
    for (const auto& [line, azimuth, elevation] :
         {std::tuple("+5 0", 5.0, 0.0), std::tuple("+5 -3", 5.0, -3.0), std::tuple("-5 +0", -5.0, 0.0),
          std::tuple("+0 -3.5", 0.0, -3.5), std::tuple("+2", 0.0, 2.0)}) {
        const auto move = parsed<MoveBy>(line);
        ASSERT_TRUE(move) << line;
        EXPECT_NEAR(move->azimuth.degrees(), azimuth, 1e-9) << line;
        EXPECT_NEAR(move->elevation.degrees(), elevation, 1e-9) << line;
    }
    const auto moved = movedBy({.azimuth = 10_deg, .elevation = 20_deg}, {.azimuth = 5_deg, .elevation = -3_deg}, kAll);
    ASSERT_TRUE(moved);
    EXPECT_NEAR(moved->azimuth.degrees(), 15.0, 1e-9);
    EXPECT_NEAR(moved->elevation.degrees(), 17.0, 1e-9);
    const auto across =
        movedBy({.azimuth = 350_deg, .elevation = 20_deg}, {.azimuth = 20_deg, .elevation = 0_deg}, kAll);
    ASSERT_TRUE(across);
    EXPECT_NEAR(across->azimuth.degrees(), 10.0, 1e-9) << "across north";
    const auto west = movedBy({.azimuth = 5_deg, .elevation = 20_deg}, {.azimuth = -10_deg, .elevation = 0_deg}, kAll);
    ASSERT_TRUE(west);
    EXPECT_NEAR(west->azimuth.degrees(), 355.0, 1e-9);
    const auto above = movedBy({.azimuth = 10_deg, .elevation = 89_deg}, {.azimuth = 0_deg, .elevation = 2_deg}, kAll);
    ASSERT_FALSE(above) << "and not over the top";
    EXPECT_EQ(above.error().code, ErrorCode::OutOfRange);
}

TEST(PairsWords, ABearingGoesToALocator)
{
    const auto position = [](std::string_view line) {
        const auto bearing = parsed<Bearing>(line);
        return bearing ? std::get<targets::EarthPosition>(bearing->target.kind) : targets::EarthPosition{};
    };
    EXPECT_NEAR(position("bearing JN58td").site.latitude.degrees(), 48.1458, 1e-3);
    EXPECT_NEAR(position("bearing jn58td").site.longitude.degrees(), 11.625, 1e-3);
    EXPECT_EQ(position("Bearing JN58td").path, targets::GreatCircle::Short);
    EXPECT_EQ(position("bearing JN58 LONG").path, targets::GreatCircle::Long);
    for (const char* const line : {"bearing", "bearing JN58td longer", "bearing JN58td long way", "bearing ZZ99",
                                   "bearing 120", "bearing JN5"}) {
        EXPECT_EQ(refused(line), ErrorCode::InvalidInput) << line;
    }
}

TEST(PairsWords, TheRestIsStopParkAndAQuestion)
{
    EXPECT_TRUE(parsed<Stop>("stop"));
    EXPECT_TRUE(parsed<Stop>("Hold"));
    EXPECT_TRUE(parsed<Stop>("STOP"));
    EXPECT_TRUE(parsed<Park>("park"));
    EXPECT_TRUE(parsed<Report>("?"));
    for (const char* const line : {"hold", " HOLD\t"}) {
        EXPECT_TRUE(isHold(line)) << line;
        EXPECT_TRUE(parsed<Stop>(line)) << line;
    }
    for (const char* const line : {"", "stop", "hold on", "holds", "10 hold"}) {
        EXPECT_FALSE(isHold(line)) << line;
    }
}

// REQ-PAIRSSERVER-02 (PairsWords.Nothing*, PairsThat.*): Text that is incomplete, invalid, too long or of another
// protocol moves nothing, and the answer gives the reason.
TEST(PairsWords, NothingElseIsACommand)
{
    for (const char* const line :
         {" ",        "10 20 30", "10,5 20",  "1e2 10",         "0x10 5", "nan 10",  "inf",    "10 north",
          "stop now", "? ?",      "120 +5",   "++5 0",          "+",      "-",       "5+ 0",   "AZ10 EL5",
          "P 10 20",  "p",        "W123 045", "GET / HTTP/1.1", "\x80",   "1 0\x01", "parked", "\xd9\xa1"}) {
        EXPECT_EQ(refused(line), ErrorCode::InvalidInput) << line;
    }
    for (const char* const line : {"3601 0", "-3601 0", "10 180.1", "-91", "99999999999999"}) {
        EXPECT_EQ(refused(line), ErrorCode::OutOfRange) << line;
    }
}

TEST(PairsWords, AnswersAreOneLine)
{
    EXPECT_EQ(reportOf({.azimuth = 120.54_deg, .elevation = -0.04_deg}), "120.5 0.0\n");
    EXPECT_EQ(refusalOf({.code = ErrorCode::Refused, .text = QStringLiteral("STOP is\nlatched. 90°")}),
              "error: STOP is latched. 90°\n");
}

}  // namespace
}  // namespace boresight::pairs
