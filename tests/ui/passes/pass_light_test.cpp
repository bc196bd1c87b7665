// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/pass_light.h"

#include "core/ephemeris/almanac.h"
#include "core/passes/pass_finder.h"

#include <gtest/gtest.h>

#include <string>

namespace boresight::ui {
namespace {

using namespace std::chrono_literals;

const Site kLightSite{.latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};

// The passes of a low orbit within two months of long nights.
PassBook lowPasses()
{
    const UtcTime from = std::chrono::sys_days{std::chrono::year{2026} / 11 / 20};
    const orbit::ElementSet elements{.name = "LOW",
                                     .number = 25544,
                                     .epoch = orbit::julianDate(from),
                                     .revolutionsPerDay = 15.5,
                                     .eccentricity = 1e-4,
                                     .inclination = 51.6_deg,
                                     .bstar = 1e-5};
    PassBook book{.satellites = std::make_shared<const std::vector<orbit::ElementSet>>(std::vector{elements}),
                  .site = kLightSite,
                  .passes = {}};
    const auto list = passes::findPasses(orbit::Sgp4(elements),
                                         {.site = kLightSite, .from = from, .to = from + 1440h, .isClear = {}});
    for (const passes::Pass& pass : list.passes) {
        book.passes.push_back({.satellite = 0, .pass = pass});
    }
    return book;
}

// REQ-PASSES-954: Of the selected pass the panel shows whether the satellite is in sunlight, and when it enters or
// leaves the shadow of the Earth.
TEST(PassLight, ALowSatelliteIsInSunlightByDayAndInTheShadowAtMidnight)
{
    const PassBook book = lowPasses();
    ephemeris::Almanac almanac(kLightSite);
    int days = 0;
    int nights = 0;
    for (const BookedPass& one : book.passes) {
        const Angle sun = almanac.place(ephemeris::Body::Sun, one.pass.tca.utc).direction.elevation;
        if (sun > 5_deg) {
            EXPECT_EQ(lightOf(one, book), (PassLight{.isSunlitFirst = true, .changes = {}}));
            ++days;
        } else if (sun < -45_deg) {  // 420 km up the Sun sets when it is 20° down for us, and a pass spans 20°
            EXPECT_EQ(lightOf(one, book), (PassLight{.isSunlitFirst = false, .changes = {}}));
            ++nights;
        }
    }
    EXPECT_GT(days, 5);
    EXPECT_GT(nights, 5);
}

TEST(PassLight, InTheEveningItEntersTheShadowAndInTheMorningItLeavesIt)
{
    const PassBook book = lowPasses();
    int changes = 0;
    for (const BookedPass& one : book.passes) {
        const PassLight light = lightOf(one, book);
        if (light.changes.size() == 1) {
            const auto hour = std::chrono::floor<std::chrono::hours>(
                                  one.pass.tca.utc - std::chrono::floor<std::chrono::days>(one.pass.tca.utc))
                                  .count();
            EXPECT_EQ(light.isSunlitFirst, hour >= 12) << "at " << hour;
            EXPECT_GT(light.changes.front(), one.pass.aos.utc);
            EXPECT_LT(light.changes.front(), one.pass.los.utc);
            ++changes;
        }
    }
    EXPECT_GT(changes, 3);
}

TEST(PassLight, IsToldInOneLine)
{
    const UtcTime first = std::chrono::sys_days{std::chrono::year{2026} / 3 / 20} + 17h + 5min + 59s;
    const auto line = [](bool sunlit, std::vector<UtcTime> changes) {
        return lightText({.isSunlitFirst = sunlit, .changes = std::move(changes)}).toStdString();
    };
    EXPECT_EQ(line(true, {}), "in sunlight");
    EXPECT_EQ(line(false, {}), "in the shadow of the Earth");
    EXPECT_EQ(line(true, {first}), "enters the shadow 17:05:59Z");
    EXPECT_EQ(line(false, {first}), "leaves the shadow 17:05:59Z");
    EXPECT_EQ(line(true, {first, first + 30min}), "in the shadow 17:05:59Z to 17:35:59Z");
    EXPECT_EQ(line(false, {first, first + 30min}), "in sunlight 17:05:59Z to 17:35:59Z");
}

}  // namespace
}  // namespace boresight::ui
