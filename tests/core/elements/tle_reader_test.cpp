// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/tle_reader.h"

#include "core/elements/tle_fields.h"

#include <gmock/gmock.h>

#include <string>

using namespace boresight;
using namespace boresight::orbit;
using testing::HasSubstr;

namespace {

const std::string kFirst = "1 25544U 98067A   24130.36689744  .00016024  00000+0  27777-3 0  9992";
const std::string kSecond = "2 25544  51.6381 147.8590 0003466 150.4670 338.5502 15.51043222452521";

// The line with the right checksum in place of its own.
std::string summed(std::string line)
{
    line.resize(kTleColumns, ' ');
    line[kTleColumns - 1] = static_cast<char>('0' + tleChecksum(line));
    return line;
}

// Columns count from 1.
std::string changed(std::string line, std::size_t column, const std::string& text)
{
    return summed(line.replace(column - 1, text.size(), text));
}

struct BadTle
{
    std::string name;
    std::string text;
    int line;
    std::string reason;
};

// REQ-ORBIT-01: Two-line and three-line sets are read completely, also mixed, with both kinds of line ends.
TEST(TleReader, ReadsEachColumn)
{
    const ElementList list = readTle("ISS (ZARYA)             \r\n" + kFirst + "\r\n" + kSecond + "  \r\n");
    ASSERT_EQ(list.sets.size(), 1U);
    EXPECT_TRUE(list.problems.empty());
    const ElementSet& set = list.sets.front();
    EXPECT_EQ(set.name, "ISS (ZARYA)");
    EXPECT_EQ(set.number, 25544);
    EXPECT_EQ(set.classification, 'U');
    EXPECT_EQ(set.designator, "1998-067A");
    EXPECT_EQ(set.epoch.day, 2460439.5);  // 2024-05-09
    EXPECT_NEAR(set.epoch.fraction, 0.36689744, 1e-12);
    EXPECT_DOUBLE_EQ(set.meanMotionDot, 0.00016024);
    EXPECT_EQ(set.meanMotionDoubleDot, 0.0);
    EXPECT_DOUBLE_EQ(set.bstar, 0.27777e-3);
    EXPECT_EQ(set.setNumber, 999);
    EXPECT_NEAR(set.inclination.degrees(), 51.6381, 1e-12);
    EXPECT_NEAR(set.ascendingNode.degrees(), 147.8590, 1e-12);
    EXPECT_DOUBLE_EQ(set.eccentricity, 0.0003466);
    EXPECT_NEAR(set.perigee.degrees(), 150.4670, 1e-12);
    EXPECT_NEAR(set.meanAnomaly.degrees(), 338.5502, 1e-12);
    EXPECT_EQ(set.revolutionsPerDay, 15.51043222);
    EXPECT_EQ(set.revolution, 45252);
}

// REQ-ORBIT-01
TEST(TleReader, TakesNamesInEachForm)
{
    const std::string pair = kFirst + "\n" + kSecond + "\n";
    const ElementList list =
        readTle("\xEF\xBB\xBF# a comment\n0 ISS\n" + pair + "\n" + pair + "Caf\xC3\xA9 1\n" + pair);
    ASSERT_EQ(list.sets.size(), 3U);
    EXPECT_EQ(list.sets[0].name, "ISS");
    EXPECT_EQ(list.sets[1].name, "");
    EXPECT_EQ(list.sets[2].name, "Caf\xC3\xA9 1");
    EXPECT_TRUE(list.problems.empty());
}

// REQ-ORBIT-02: Alpha-5 catalogue numbers are read.
TEST(TleReader, ReadsAlpha5)
{
    EXPECT_EQ(tleNumber("A0000"), 100000);
    EXPECT_EQ(tleNumber("T1234"), 271234);
    EXPECT_EQ(tleNumber("Z9999"), 339999);
    EXPECT_EQ(tleNumber("5"), 5);
    for (const char* const wrong : {"I0000", "O0000", "a0000", "A000", "AB000", "1A000", "", "-1", "1.5"}) {
        EXPECT_EQ(tleNumber(wrong), std::nullopt) << wrong;
    }
    const ElementList list = readTle(changed(kFirst, 3, "T1234") + "\n" + changed(kSecond, 3, "T1234"));
    ASSERT_EQ(list.sets.size(), 1U);
    EXPECT_EQ(list.sets.front().number, 271234);
}

// REQ-ORBIT-01
TEST(TleReader, TakesOtherFormsOfNumbers)
{
    const auto bstar = [](const std::string& text) {
        const ElementList list = readTle(changed(kFirst, 54, text) + "\n" + kSecond);
        return list.sets.empty() ? -1.0 : list.sets.front().bstar;
    };
    EXPECT_DOUBLE_EQ(bstar(" 12345-3"), 0.12345e-3);
    EXPECT_DOUBLE_EQ(bstar("-12345-3"), -0.12345e-3);
    EXPECT_DOUBLE_EQ(bstar("+12345+1"), 1.2345);
    EXPECT_DOUBLE_EQ(bstar(" 123e-03"), 0.123e-3);
    EXPECT_EQ(bstar(" 00000-0"), 0.0);
    EXPECT_EQ(bstar(" 00000+0"), 0.0);
    const ElementList list = readTle(kFirst + "\n" + changed(kSecond, 9, "   4.5  "));
    ASSERT_EQ(list.sets.size(), 1U);
    EXPECT_NEAR(list.sets.front().inclination.degrees(), 4.5, 1e-12);
}

// REQ-ORBIT-03: A bad set is reported with its line and the reason, and the others are used.
TEST(TleReader, EachBadSetIsReportedAndTheOthersAreUsed)
{
    const std::string good = kFirst + "\n" + kSecond + "\n";
    const std::vector<BadTle> cases{
        {"checksum", kFirst.substr(0, 68) + "5\n" + kSecond, 3, "checksum in column 69 is \"5\", expected 2"},
        {"checksum2", kFirst + "\n" + kSecond.substr(0, 68) + "x", 4, "expected 1"},
        {"short", kFirst.substr(0, 60) + "\n" + kSecond, 3, "60 columns instead of 69"},
        {"long", kFirst + "9\n" + kSecond, 3, "after column 69"},
        {"shifted", changed(kFirst, 9, "X") + "\n" + kSecond, 3, "Column 9 is not blank"},
        {"numbers", changed(kFirst, 3, "25545") + "\n" + kSecond, 4, "25545, line 2 has 25544"},
        {"no line 2", kFirst, 3, "no line 2"},
        {"no line 1", kSecond, 3, "no line 1"},
        {"letters", kFirst + "\n" + changed(kSecond, 9, " 51.x381"), 4, "(the inclination) hold \"51.x381\""},
        {"exponent", kFirst + "\n" + changed(kSecond, 9, " 5.1e001"), 4, "the inclination"},
        {"eccentricity", kFirst + "\n" + changed(kSecond, 27, "00-3466"), 4, "the eccentricity"},
        {"motion", kFirst + "\n" + changed(kSecond, 53, " 0.00000000"), 4, "mean motion is 0 rev/day"},
        {"backwards", kFirst + "\n" + changed(kSecond, 53, "-1.00000000"), 4, "must be above 0"},
        {"inclination", kFirst + "\n" + changed(kSecond, 9, "190.0000"), 4, "inclination is 190"},
        {"angle", kFirst + "\n" + changed(kSecond, 18, "361.0000"), 4, "361"},
        {"blank", kFirst + "\n" + changed(kSecond, 35, "        "), 4, "argument of the perigee"},
        {"day", changed(kFirst, 21, "367.00000000") + "\n" + kSecond, 3,
         "day 367 of the epoch is not in the year 2024"},
        {"day 0", changed(kFirst, 21, "000.50000000") + "\n" + kSecond, 3, "day 0.5"},
        {"drag", changed(kFirst, 54, " 27777-x") + "\n" + kSecond, 3, "the drag term"},
        {"theory", changed(kFirst, 63, "4") + "\n" + kSecond, 3, "SGP4-XP"},
        {"year", changed(kFirst, 19, "  ") + "\n" + kSecond, 3, "the year of the epoch"},
        {"cut digits", kFirst + "\n" + changed(kSecond, 27, "000346 "), 4, "the eccentricity"},
        {"sum of a plus", changed(kFirst, 54, "+27777-3").replace(68, 1, "3") + "\n" + kSecond, 3, "expected 2"},
        {"cut file", kFirst + "\n2 25544  51.6381", 4, "16 columns instead of 69"},
        {"number", changed(kFirst, 3, "I5544") + "\n" + kSecond, 3, "catalogue number"},
        {"page", "<html>not found</html>\nNAME", 3, "\"<html>not found</html>\" is not part"}};
    for (const BadTle& bad : cases) {
        const ElementList list = readTle(good + bad.text + "\n" + good);
        EXPECT_EQ(list.sets.size(), 2U) << bad.name;
        ASSERT_EQ(list.problems.size(), 1U) << bad.name;
        EXPECT_EQ(list.problems.front().line, bad.line) << bad.name;
        EXPECT_THAT(list.problems.front().reason.toStdString(), HasSubstr(bad.reason)) << bad.name;
    }
}

// REQ-ORBIT-01
TEST(TleReader, ANameMayBeginLikeALineOfElements)
{
    const std::string pair = kFirst + "\n" + kSecond + "\n";
    const ElementList list = readTle("1 SMALL SAT\n" + pair + "2 SMALL SAT\n" + pair + "0 0 SAT\n" + pair);
    ASSERT_EQ(list.sets.size(), 3U);
    EXPECT_EQ(list.sets[0].name, "1 SMALL SAT");
    EXPECT_EQ(list.sets[1].name, "2 SMALL SAT");
    EXPECT_EQ(list.sets[2].name, "0 SAT");
    EXPECT_TRUE(list.problems.empty());
}

// REQ-ORBIT-03
TEST(TleReader, KeepsPrintableWordsOnly)
{
    const std::string first = changed(changed(kFirst, 8, "\x01"), 10, "98\x1b[1mA");
    const ElementList list = readTle("Caf\xE9 \x1b[1m" + std::string(80, 'x') + "\n" + first + "\n" + kSecond);
    ASSERT_EQ(list.sets.size(), 1U);
    EXPECT_EQ(list.sets.front().name, "Caf\xEF\xBF\xBD ?[1m" + std::string(51, 'x') + "\xE2\x80\xA6");
    EXPECT_EQ(list.sets.front().classification, 'U');
    EXPECT_EQ(list.sets.front().designator, "98?[1mA");
}

// REQ-ORBIT-03
TEST(TleReader, ReadsThousandsOfSetsWithBadOnesAmongThem)
{
    std::string text;
    for (int i = 0; i < 20000; ++i) {
        const std::string number = std::to_string(10000 + i);
        text += "SAT " + number + "\n" + changed(kFirst, 3, number) + "\n";
        text += (i % 100 == 99 ? kFirst : changed(kSecond, 3, number)) + "\n";
    }
    const ElementList list = readTle(text);
    EXPECT_EQ(list.sets.size(), 19800U);
    EXPECT_EQ(list.sets.back().name, "SAT 29998");
    EXPECT_EQ(list.problems.size() + list.furtherProblems, 400U);
}

// REQ-ORBIT-03
TEST(TleReader, KeepsTheFirstProblemsOfAFileOfAnotherKind)
{
    std::string text;
    for (int i = 0; i < 5000; ++i) {
        text += "\x01garbage\xFF\n";
    }
    const ElementList list = readTle(text);
    EXPECT_EQ(list.problems.size(), ElementList::kMostProblems);
    EXPECT_EQ(list.furtherProblems, 4000U);
    EXPECT_EQ(list.problems.front().reason.toStdString(), "\"?garbage\xEF\xBF\xBD\" is not part of an element set.");
}

// REQ-ORBIT-03
TEST(TleReader, AHugeFileOfAnotherKindIsNotReadToItsEnd)
{
    std::string text;
    for (int i = 0; i < 200'000; ++i) {
        text += "x\n";
    }
    EXPECT_LE(readTle(text).furtherProblems, ElementList::kMostFurtherProblems + 1);
}

// REQ-ORBIT-01
TEST(TleReader, KnowsTheCentury)
{
    const auto day = [](const std::string& year) {
        const ElementList list = readTle(changed(kFirst, 19, year) + "\n" + kSecond);
        return list.sets.empty() ? 0.0 : list.sets.front().epoch.day;
    };
    EXPECT_EQ(day("57"), julianDate(1957, 129.0).day);
    EXPECT_EQ(day("99"), julianDate(1999, 129.0).day);
    EXPECT_EQ(day("00"), julianDate(2000, 129.0).day);
    EXPECT_EQ(day("56"), julianDate(2056, 129.0).day);
}

}  // namespace
