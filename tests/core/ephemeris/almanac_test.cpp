// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ephemeris/almanac.h"

#include "core/ephemeris/refraction.h"
#include "core/units/angle_between.h"
#include "tests/core/ephemeris/body_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace boresight;
using namespace boresight::ephemeris;

namespace {

struct Worst
{
    int rows = 0;
    double arcMinutes = 0.0;
    double kilometres = 0.0;
};

std::map<Body, Worst> compareWithTheTable()
{
    std::map<Body, Worst> worst;
    for (const BodyRow& row : bodyTable()) {
        const BodyPlace place = Almanac(siteOf(row.site)).place(row.body, row.utc);
        Worst& here = worst[row.body];
        ++here.rows;
        here.arcMinutes = std::max(here.arcMinutes, 60.0 * angleBetween(place.direction, row.direction).degrees());
        here.kilometres = std::max(here.kilometres, std::abs(place.kilometres - row.kilometres));
    }
    return worst;
}

}  // namespace

// 120 times of 2024 to 2030 at three sites each, and one whole day.
// REQ-EPHEMERIS-01: Sun within 0.05′, Moon within 0.3′ of the reference table, 2024 to 2030, at three latitudes.
TEST(Almanac, MeetsTheTableOfSunAndMoon)
{
    const auto worst = compareWithTheTable();
    ASSERT_EQ(worst.at(Body::Sun).rows, 504);
    ASSERT_EQ(worst.at(Body::Moon).rows, 504);
    RecordProperty("sun_arcmin", std::to_string(worst.at(Body::Sun).arcMinutes));
    RecordProperty("moon_arcmin", std::to_string(worst.at(Body::Moon).arcMinutes));
    EXPECT_LE(worst.at(Body::Sun).arcMinutes, 0.005) << "0.05 would do; this is how exact the table is";
    EXPECT_LE(worst.at(Body::Moon).arcMinutes, 0.16) << "0.3 would do";
    EXPECT_LE(worst.at(Body::Sun).kilometres, 100.0);
    EXPECT_LE(worst.at(Body::Moon).kilometres, 30.0);
}

// The worked example of Reda and Andreas, "Solar Position Algorithm for Solar Radiation Applications",
// NREL/TP-560-34302 (2008), table A5.1. It does not use ERFA, and its date is before two of the leap seconds.
// REQ-EPHEMERIS-02: The Sun agrees with a published example that was computed by another method.
TEST(Almanac, MeetsThePublishedExampleOfTheSun)
{
    Almanac golden({.latitude = 39.742476_deg, .longitude = -105.1786_deg, .heightMetres = 1830.14});
    const BodyPlace sun = golden.place(Body::Sun, utcOf("2003-10-17T19:30:30Z"));
    EXPECT_NEAR(sun.direction.azimuth.degrees(), 194.34024, 0.001);
    EXPECT_NEAR(sun.direction.elevation.degrees(), 39.872046, 0.001);
    const Air air{.pressureHectopascal = 820.0, .temperatureCelsius = 11.0};
    EXPECT_NEAR(apparent(sun.direction, Refraction::Light, air).elevation.degrees(), 90.0 - 50.11162, 0.001);
}

// From the distances on 3 January and 6 July 2026, when the Sun is widest (32.5′) and narrowest (31.5′).
// REQ-EPHEMERIS-03: The almanac gives the diameters of the discs.
TEST(Almanac, TellsHowWideTheDiscsAre)
{
    Almanac lisbon(siteOf("Lisbon"));
    EXPECT_NEAR(120.0 * lisbon.place(Body::Sun, utcOf("2026-01-03T12:00:00Z")).radius.degrees(), 32.53, 0.02);
    EXPECT_NEAR(120.0 * lisbon.place(Body::Sun, utcOf("2026-07-06T12:00:00Z")).radius.degrees(), 31.46, 0.02);
    for (int day = 0; day < 60; ++day) {
        const BodyPlace moon = lisbon.place(Body::Moon, utcOf("2026-01-01T00:00:00Z") + std::chrono::days(day));
        EXPECT_GT(120.0 * moon.radius.degrees(), 29.0) << day;
        EXPECT_LT(120.0 * moon.radius.degrees(), 34.3) << day;
    }
}

// Values that are kept for a minute change no result, whatever the order of the times.
// REQ-EPHEMERIS-04: Values that are kept between calls change no result.
TEST(Almanac, RemembersNothingThatShows)
{
    Almanac used(siteOf("Sydney"));
    const UtcTime start = utcOf("2026-03-20T02:00:00Z");
    for (const int second : {0, 59, 60, 61, -1, 119, 86400, 30}) {
        for (const Body body : {Body::Sun, Body::Moon}) {
            const UtcTime utc = start + std::chrono::seconds(second);
            EXPECT_EQ(used.place(body, utc), Almanac(siteOf("Sydney")).place(body, utc)) << second;
        }
    }
}

// Nothing jumps where the Earth axis of the next minute is used: the path is the same from second to second.
// REQ-EPHEMERIS-04
TEST(Almanac, MovesEvenlyFromMinuteToMinute)
{
    Almanac sydney(siteOf("Sydney"));
    const UtcTime start = utcOf("2026-03-20T02:00:58Z");
    const auto way = [&](int second) {
        const UtcTime utc = start + std::chrono::seconds(second);
        return angleBetween(sydney.place(Body::Sun, utc).direction,
                            sydney.place(Body::Sun, utc + std::chrono::seconds(1)).direction);
    };
    EXPECT_NEAR(3600.0 * way(0).degrees(), 15.0, 0.1);
    EXPECT_NEAR(3600.0 * way(0).degrees(), 3600.0 * way(1).degrees(), 0.001);
    EXPECT_NEAR(3600.0 * way(1).degrees(), 3600.0 * way(2).degrees(), 0.001);
}
