// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/horizon_text.h"

#include "core/base/numbers.h"
#include "core/pointing/skyline.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

using namespace boresight;
using namespace boresight::profile;

namespace {

// The points as "0:10 90:20", or the error.
std::string pointsOf(std::string_view text)
{
    const auto horizon = parseHorizon(text, QStringLiteral("h.txt"));
    if (!horizon) {
        return textOf(horizon.error());
    }
    std::string points;
    for (const pointing::HorizonPoint& point : horizon->points) {
        points += (points.empty() ? "" : " ") + formatFixed(point.azimuth.degrees(), 2) + ":" +
                  formatFixed(point.elevation.degrees(), 2);
    }
    return points;
}

}  // namespace

// The forms that other programs write.
// REQ-PROFILE-14 (HorizonText.*): Horizons of other programs are read, with all errors by line. They are written in a
// form that those programs can read.
TEST(HorizonText, ReadsWhatOthersWrite)
{
    EXPECT_EQ(pointsOf("# N.I.N.A.\n0 10\n90 20\n180 30\n270 20\n360 10\n"),
              "0.00:10.00 90.00:20.00 180.00:30.00 270.00:20.00");
    EXPECT_EQ(pointsOf("\xef\xbb\xbf# Radio Eyes\r\n\r\n0 39.9\r\n10\t39.9 # roof\r\n20   25.0"),
              "0.00:39.90 10.00:39.90 20.00:25.00");
    EXPECT_EQ(pointsOf("1, 15\n2,19\n18 , 37\n33 ,45\n"), "1.00:15.00 2.00:19.00 18.00:37.00 33.00:45.00");
    EXPECT_EQ(pointsOf("azimuth,elevation\n160,20\n180,-1.5\n"), "160.00:20.00 180.00:-1.50");
    EXPECT_EQ(pointsOf("Azimut;Höhe\n12,5;3,25\n100;4\n"), "12.50:3.25 100.00:4.00");
    EXPECT_EQ(pointsOf("12,5 3,25\n13,5\t4,25\n"), "12.50:3.25 13.50:4.25");
    EXPECT_EQ(pointsOf("AZ-ALT\n+7 1e1\n"), "7.00:10.00");
}

TEST(HorizonText, SortsByAzimuth)
{
    EXPECT_EQ(pointsOf("270 3\n0 1\n90 2\n"), "0.00:1.00 90.00:2.00 270.00:3.00");
}

// The side of a tower: two points at the same azimuth. The horizon must not lie below either of them.
TEST(HorizonText, OfOneAzimuthTheHighestElevationCounts)
{
    const auto horizon = parseHorizon("10 0\n10 20\n30 20\n30 0\n0 5\n360 7\n50 1\n50 1\n", QStringLiteral("h.txt"));
    ASSERT_TRUE(horizon) << textOf(horizon.error());
    EXPECT_EQ(horizon->points, (std::vector<pointing::HorizonPoint>{
                                   {0_deg, 7_deg}, {10_deg, 20_deg}, {30_deg, 20_deg}, {50_deg, 1_deg}}));
    EXPECT_EQ(horizon->merged, 3) << "the same point again is nothing to tell of";
}

TEST(HorizonText, JustBelowNorthIsNorth)
{
    EXPECT_EQ(pointsOf("359.9999999 4\n"), "0.00:4.00");
}

TEST(HorizonText, TellsAllErrorsWithTheirLines)
{
    EXPECT_EQ(pointsOf("azimuth elevation\n"
                       "-90 5\n"
                       "10 5\n"
                       "361 5\n"
                       "# fine\n"
                       "20 90.5\n"
                       "30\n"
                       "40 1 2\n"
                       "azimuth elevation\n"
                       "nan 3\n"
                       "1,2,3\n"
                       "ten\x1b 5\n"),
              "h.txt:2: azimuths count from north, 0…360\n"
              "h.txt:4: azimuths count from north, 0…360\n"
              "h.txt:6: an elevation is within -90…90\n"
              "h.txt:7: azimuth and elevation are expected, like \"120.5 7\", not \"30\"\n"
              "h.txt:8: azimuth and elevation are expected, like \"120.5 7\", not \"40 1 2\"\n"
              "h.txt:9: azimuth and elevation are expected, like \"120.5 7\", not \"azimuth elevation\"\n"
              "h.txt:10: azimuth and elevation are expected, like \"120.5 7\", not \"nan 3\"\n"
              "h.txt:11: azimuth and elevation are expected, like \"120.5 7\", not \"1,2,3\"\n"
              "h.txt:12: azimuth and elevation are expected, like \"120.5 7\", not \"ten? 5\"");
}

TEST(HorizonText, IsSomethingAndNotTooMuch)
{
    EXPECT_EQ(pointsOf(""), "h.txt: 0 points. A horizon has 1 to 3600 points");
    EXPECT_EQ(pointsOf("# nothing\nwords\n"), "h.txt: 0 points. A horizon has 1 to 3600 points");
    std::string many;
    for (int i = 0; i < 3601; ++i) {
        many += formatFixed(0.05 * i, 2) + " 1\n";
    }
    EXPECT_EQ(pointsOf(many), "h.txt: 3601 points. A horizon has 1 to 3600 points");
    std::string other;
    for (int i = 0; i < 23; ++i) {
        other += "x y\n";
    }
    EXPECT_TRUE(pointsOf(other).ends_with("\n… and 2 more")) << pointsOf(other);
}

TEST(HorizonText, WritesItClosedThroughNorth)
{
    const std::vector<pointing::HorizonPoint> horizon{{90_deg, 10_deg}, {270_deg, 20.5_deg}};
    const std::string text = toHorizonText(horizon, "mast\n2");
    EXPECT_EQ(text,
              "# Horizon of mast?2: azimuth from north, elevation, in degrees; straight lines between\n"
              "0.0 15.25\n90.0 10.0\n270.0 20.5\n360.0 15.25\n");
    const auto again = parseHorizon(text, QStringLiteral("h.txt"));
    ASSERT_TRUE(again) << textOf(again.error());
    const pointing::Skyline before(horizon);
    const pointing::Skyline after(again->points);
    for (int azimuth = 0; azimuth < 360; ++azimuth) {
        const Angle angle = Angle::fromDegrees(azimuth);
        EXPECT_NEAR(before.at(angle).degrees(), after.at(angle).degrees(), 1e-9) << azimuth;
    }
    EXPECT_FALSE(parseHorizon(toHorizonText({}, "mast"), QStringLiteral("h.txt"))) << "no points: nothing to read";
}
