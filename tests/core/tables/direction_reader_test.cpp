// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/direction_reader.h"

#include <gmock/gmock.h>

#include <string>

namespace boresight::tables {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::StartsWith;

const AtomicTime kFirst = atomicTime(std::chrono::sys_days(std::chrono::year(2026) / 12 / 24));

// The error as "2: reason".
std::string mistakeIn(const std::string& text)
{
    const auto rows = readDirections(text);
    return rows ? "accepted" : std::to_string(rows.error().line) + ": " + rows.error().reason.toStdString();
}

// REQ-TABLES-910: A tracking table has a time, an azimuth and an elevation in each row, separated by commas,
// semicolons, tabs or blanks. Further columns, comments, blank lines and a header line are ignored.
TEST(DirectionReader, ReadsTheFormsOfARow)
{
    const DirectionRows wanted{{kFirst, {10.5_deg, 20_deg}}, {kFirst + 1min, {349.5_deg, 20.25_deg}}};
    for (const char* const text :
         {"2026-12-24T00:00:00Z,10.5,20\n2026-12-24T00:01:00Z,349.5,20.25\n",
          "# Moon\r\n\r\n2026-12-24 00:00:00 10.5 20\r\n2026-12-24 00:01:00 -10.5 +20.25\r\n",
          "time\taz\tel\n2026-12-24T00:00\t10.5\t20\n2026-12-24T00:01\t349.5\t20.25",
          "t_utc,az_deg,el_deg,range_km\n2026-12-24, 10.5 , 20,400\n2026-12-24T00:01:00Z;349.5; 20.25; 300\n",
          "1798070400 10.5 20\n  1798070460.000   349.5   20.25  # so\n",
          "2026-358T00:00:00 10.5 20\n2026-358T00:01:00 349.5 20.25\n"}) {
        const auto rows = readDirections(text);
        ASSERT_TRUE(rows) << text << rows.error().reason.toStdString();
        EXPECT_EQ(rows->size(), 2U) << text;
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_EQ((*rows)[i].time, wanted[i].time) << text;
            EXPECT_NEAR((*rows)[i].direction.azimuth.degrees(), wanted[i].direction.azimuth.degrees(), 1e-9) << text;
            EXPECT_EQ((*rows)[i].direction.elevation, wanted[i].direction.elevation) << text;
        }
    }
}

// REQ-TABLES-911: A table with an error is refused as a whole, with the line, the error and what to do.
TEST(DirectionReader, NamesTheLineOfAMistake)
{
    const std::string row = "2026-12-24T00:00:00Z,10,20\n";
    EXPECT_THAT(mistakeIn(""), HasSubstr("1: There is no row."));
    EXPECT_THAT(mistakeIn("# only\ntime az el\n"), HasSubstr("There is no row."));
    EXPECT_THAT(mistakeIn(row + "time,az,el\n"), StartsWith("2: \"time\" is not a time. A row is a time in UTC like"));
    EXPECT_THAT(mistakeIn("12:00:00 10 20\n"), StartsWith("1: \"12:00:00\" is not a time."));
    EXPECT_THAT(mistakeIn(row + "2026-12-24T00:01:00Z,10\n"), StartsWith("2: The row has no elevation."));
    EXPECT_THAT(mistakeIn(row + "2026-12-24T00:01:00Z,,20\n"), StartsWith("2: The azimuth \"\" is not a number"));
    EXPECT_THAT(mistakeIn(row + "2026-12-24T00:01:00Z,1e3,20\n"),
                StartsWith("2: The azimuth is 1e3°. It must be from -360° to 360°."));
    EXPECT_THAT(mistakeIn(row + "2026-12-24T00:01:00Z,inf,20\n"), StartsWith("2: The azimuth \"inf\" is not"));
    EXPECT_THAT(mistakeIn(row + "2026-12-24T00:01:00Z,10,90.1\n"),
                StartsWith("2: The elevation is 90.1°. It must be from -90° to 90°."));
    EXPECT_THAT(mistakeIn(row + row), StartsWith("2: The time is not later than the time in the row above. Sort"));
    EXPECT_THAT(
        mistakeIn(row + "2026-12-24T00:01:00Z,190,20\n"),
        StartsWith("2: The direction is 140.0° from the direction in the row above. It must be below 90°. Add"));
}

// REQ-TABLES-912: A step of more than an hour is not interpolated. A row without another row within an hour is refused.
TEST(DirectionReader, ALongStepIsAGap)
{
    const auto rows = readDirections(
        "2026-12-24T00:00:00Z,10,0\n2026-12-24T01:00:00Z,20,1\n2026-12-24T02:00:01Z,280,0\n2026-12-24T02:10:00Z,290,"
        "1\n");
    ASSERT_TRUE(rows);
    EXPECT_EQ(spansOf(*rows), (std::vector<TableSpan>{{kFirst, kFirst + 1h}, {kFirst + 2h + 1s, kFirst + 2h + 10min}}));
    const std::string pair = "2026-12-24T00:00:00Z,10,0\n2026-12-24T00:01:00Z,11,0\n";
    EXPECT_THAT(mistakeIn("2026-12-24T00:00:00Z,10,0\n"), StartsWith("1: The row has no other row within an hour."));
    EXPECT_THAT(mistakeIn(pair + "2026-12-24T02:00:00Z,12,0\n2026-12-24T04:00:00Z,12,0\n"),
                StartsWith("3: The row has"));
    EXPECT_THAT(mistakeIn(pair + "\n2026-12-24T02:00:00Z,12,0\n"), StartsWith("4: The row has no other row"));
}

}  // namespace
}  // namespace boresight::tables
