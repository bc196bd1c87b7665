// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/azel/moon_check.h"

#include <gtest/gtest.h>

namespace boresight::azel {
namespace {

// The middle of IM58KS.
const Site kHome{.latitude = 38.7708_deg, .longitude = -9.125_deg, .heightMetres = 0.0};

AzelFeed feedOf(const char* moon, UtcTime utc)
{
    const std::string time = "22:30:04,";
    const std::string text = time + moon + ",Moon\n" + time + "298.4,-59.7,Sun\n 1296,0,0,0,0,Doppler, R\n";
    AzelFeed feed;
    feed.take({.path = QStringLiteral("azel.dat"), .text = readAzelText(text)}, {}, utc);
    EXPECT_TRUE(feed.text());
    return feed;
}

// REQ-AZEL-908: The recorded Moon of WSJT-X agrees with the computed Moon within its steps of 0.1°. A Moon of another
// locator is detected, whatever the clock of this computer shows.
TEST(MoonCheck, FindsAWrongLocator)
{
    using namespace std::chrono;
    const UtcTime utc = sys_days{2026y / November / 24} + 22h + 30min + 4s;
    ephemeris::Almanac almanac(kHome);
    for (const seconds late : {-20s, 0s, 20s}) {
        const Angle apart = moonApart(feedOf("105.3, 59.9", utc + late), almanac);
        EXPECT_LT(apart, 0.08_deg);
        EXPECT_EQ(moonCheck(apart), MoonCheck::Agrees);
    }
    EXPECT_EQ(moonCheck(moonApart(feedOf("106.0, 60.2", utc), almanac)), MoonCheck::Differs);
    EXPECT_EQ(moonCheck(moonApart(feedOf(" 80.0, 20.0", utc), almanac)), MoonCheck::Elsewhere);
}

}  // namespace
}  // namespace boresight::azel
