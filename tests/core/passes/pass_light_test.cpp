// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/passes/pass_light.h"

#include "core/ephemeris/almanac.h"
#include "core/passes/pass_finder.h"
#include "tests/fakes/low_orbit.h"

#include <gtest/gtest.h>

namespace boresight::passes {
namespace {

using namespace std::chrono_literals;

const Site kLightSite{.latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};

// On a low orbit, for two months of long nights.
struct LowOrbit
{
    UtcTime from = std::chrono::sys_days{std::chrono::year{2026} / 11 / 20};
    orbit::ElementSet elements = fakes::lowOrbit(from);
    std::vector<Pass> passes =
        findPasses(orbit::Sgp4(elements), {.site = kLightSite, .from = from, .to = from + 1440h, .isClear = {}}).passes;

    [[nodiscard]] PassLight light(const Pass& pass) const { return lightOf(pass, elements, kLightSite); }
};

// REQ-PASSES-954: For the selected pass the panel shows whether the satellite is in sunlight, and when it enters or
// leaves the shadow of the Earth.
TEST(PassLight, ALowSatelliteIsInSunlightByDayAndInTheShadowAtMidnight)
{
    const LowOrbit low;
    ephemeris::Almanac almanac(kLightSite);
    int days = 0;
    int nights = 0;
    for (const Pass& pass : low.passes) {
        const Angle sun = almanac.place(ephemeris::Body::Sun, pass.tca.utc).direction.elevation;
        if (sun > 5_deg) {
            EXPECT_EQ(low.light(pass), (PassLight{.isSunlitFirst = true, .changes = {}}));
            ++days;
        } else if (sun < -45_deg) {  // 420 km up the Sun sets when it is 20° below our horizon, and a pass spans 20°
            EXPECT_EQ(low.light(pass), (PassLight{.isSunlitFirst = false, .changes = {}}));
            ++nights;
        }
    }
    EXPECT_GT(days, 5);
    EXPECT_GT(nights, 5);
}

TEST(PassLight, InTheEveningItEntersTheShadowAndInTheMorningItLeavesIt)
{
    const LowOrbit low;
    int changes = 0;
    for (const Pass& pass : low.passes) {
        const PassLight light = low.light(pass);
        if (light.changes.size() == 1) {
            const auto hour = std::chrono::floor<std::chrono::hours>(
                                  pass.tca.utc - std::chrono::floor<std::chrono::days>(pass.tca.utc))
                                  .count();
            EXPECT_EQ(light.isSunlitFirst, hour >= 12) << "at " << hour;
            EXPECT_GT(light.changes.front(), pass.aos.utc);
            EXPECT_LT(light.changes.front(), pass.los.utc);
            ++changes;
        }
    }
    EXPECT_GT(changes, 3);
}

// REQ-PASSES-992: For each pass it is known for how many seconds the satellite is in sunlight.
TEST(PassLight, TheTimeInSunlightIsTheSumOfItsParts)
{
    const UtcTime rise = std::chrono::sys_days{std::chrono::year{2026} / 11 / 20};
    const Pass pass{.aos = {.utc = rise, .direction = {}}, .tca = {}, .los = {.utc = rise + 600s, .direction = {}}};
    const auto time = [&](bool isSunlitFirst, const std::vector<UtcTime>& changes) {
        return sunlitTime(pass, {.isSunlitFirst = isSunlitFirst, .changes = changes}).count();
    };
    EXPECT_EQ(time(true, {}), 600.0);
    EXPECT_EQ(time(false, {}), 0.0);
    EXPECT_EQ(time(true, {rise + 250s}), 250.0);
    EXPECT_EQ(time(false, {rise + 250s}), 350.0);
    EXPECT_EQ(time(true, {rise + 100s, rise + 400s}), 300.0);
    EXPECT_EQ(time(false, {rise + 100s, rise + 400s, rise + 550s}), 350.0);
}

}  // namespace
}  // namespace boresight::passes
