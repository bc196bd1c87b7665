// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/conversions.h"

#include <gtest/gtest.h>

// The values of Hamlib 4.5.4. The recorded exchanges have more of them.
namespace boresight::rotctld {
namespace {

TEST(Conversions, LocatorsOfPlacesAndBack)
{
    EXPECT_EQ(toLocator({.longitude = -0.1275, .latitude = 51.507}, 6), "IO91WM");
    EXPECT_EQ(toLocator({.longitude = 500.0, .latitude = 100.0}, 6), "QB00AA");
    EXPECT_EQ(toLocator({.longitude = 180.0, .latitude = 90.0}, 6), "AA00AA");
    EXPECT_EQ(toLocator({.longitude = 9.5, .latitude = 50.1}, 3), "JO");
    EXPECT_EQ(toLocator({.longitude = -82.6515, .latitude = 52.0}, 13), "EO82QA10TA60");
    EXPECT_EQ(toLocator({.longitude = 9.5, .latitude = 50.1}, 1), std::nullopt);
    EXPECT_EQ(toLocator({.longitude = 9.5, .latitude = 50.1}, 14), std::nullopt);
    EXPECT_EQ(toLocator({.longitude = 1e9, .latitude = 50.1}, 6), std::nullopt);
    EXPECT_NEAR(fromLocator("JO22ab34")->longitude, 4.029167, 1e-6);
    EXPECT_NEAR(fromLocator("JO2")->longitude, 10.0, 1e-9);
    for (const char* bad : {"", "J", "ZZ99", "JOAA", "JO22yy", "JO22abcdefgh12"}) {
        EXPECT_FALSE(fromLocator(bad).has_value()) << bad;
    }
}

// The centre of every square lies in this square.
TEST(Conversions, LocatorOfACentreIsTheLocator)
{
    for (const char* locator : {"AA00AA", "RR99XX", "JO22AA", "IO91WM", "QF56OD", "FN31PR"}) {
        EXPECT_EQ(toLocator(*fromLocator(locator), 6), locator);
    }
}

TEST(Conversions, DegreesMinutesSeconds)
{
    EXPECT_NEAR(toDegrees({.degrees = -10, .minutes = 30, .seconds = 30.0, .negative = true}), -10.508333, 1e-6);
    const auto half = toDegreesMinutesSeconds(-0.5);
    EXPECT_EQ(half.degrees, 0);
    EXPECT_EQ(half.minutes, 30);
    EXPECT_TRUE(half.negative);
    EXPECT_EQ(toDegreesMinutesSeconds(180.0).degrees, 180);
    EXPECT_FALSE(toDegreesMinutesSeconds(-180.0).negative);
    EXPECT_EQ(toDegreesMinutesSeconds(360.0).degrees, 0);
}

TEST(Conversions, GreatCircles)
{
    const auto fromPole = greatCircle({.longitude = 0.0, .latitude = 90.0}, {.longitude = 10.0, .latitude = 10.0});
    EXPECT_NEAR(fromPole->kilometres, 8896.0, 1e-5);
    EXPECT_EQ(fromPole->azimuth, 170.0);
    EXPECT_EQ(greatCircle({.longitude = 1.0, .latitude = 1.0}, {.longitude = 1.0, .latitude = 1.0})->kilometres, 0.0);
    EXPECT_FALSE(greatCircle({.longitude = 0.0, .latitude = 90.1}, {}).has_value());
    EXPECT_FALSE(greatCircle({}, {.longitude = -180.1, .latitude = 0.0}).has_value());
}

TEST(Conversions, LongPaths)
{
    EXPECT_EQ(longPathAzimuth(0.0), 180.0);
    EXPECT_EQ(longPathAzimuth(180.0), 0.0);
    EXPECT_EQ(longPathAzimuth(360.0), 180.0);
    EXPECT_EQ(longPathAzimuth(359.5), 179.5);
    EXPECT_EQ(longPathAzimuth(361.0), std::nullopt);
    EXPECT_EQ(longPathDistance(1000.0), 39032.0);
}

}  // namespace
}  // namespace boresight::rotctld
