// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/system/simulated_station.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

// The remaining time shown for a slew, compared with the time that the simulated antenna takes.
namespace boresight::system_test {
namespace {

constexpr Angle kAtTheTarget = Angle::fromDegrees(0.1);

struct SlewCase
{
    const char* name;
    AxisPosition from;
    Request request;
    AxisPosition to;
};

void expectTimeOf(const SlewCase& one, profile::Arrival arrival)
{
    SCOPED_TRACE(one.name);
    profile::Profile profile = anyPort();
    profile.control.arrival = arrival;
    profile.park = {.azimuth = 250_deg, .elevation = 85_deg};
    profile.limits.keepOuts = {
        {.name = "mast", .azimuthFrom = 300_deg, .azimuthTo = 330_deg, .elevationMin = 0_deg, .elevationMax = 40_deg}};
    SimulatedStation rig(profile);
    ASSERT_EQ(rig.ask(request::PointAxes{one.from}), "");
    ASSERT_TRUE(rig.settle());
    ASSERT_EQ(rig.ask(one.request), "");
    ASSERT_TRUE(rig.runUntil([&] { return rig.status().slew.has_value(); }, Seconds(1.0)));
    std::vector<std::pair<SteadyTime, Seconds>> shown;
    for (int second = 0; second < 4; ++second) {
        if (const auto slew = rig.status().slew) {
            shown.emplace_back(rig.clock.now(), slew->remaining);
        }
        rig.run(Seconds(1.0));
    }
    EXPECT_GE(shown.size(), 3U);
    ASSERT_TRUE(rig.runUntil([&] { return rig.farthestFrom(one.to) < kAtTheTarget; }, Seconds(120.0)));
    for (const auto& [when, remaining] : shown) {
        const double took = Seconds(rig.clock.now() - when).count();
        EXPECT_NEAR(remaining.count(), took, std::max(0.5, 0.1 * took));
    }
    ASSERT_TRUE(rig.settle());
    EXPECT_FALSE(rig.status().slew.has_value());
}

// REQ-CONTROL-400
TEST(SlewTime, IsThatOfTheSimulatedAntenna)
{
    const std::vector<SlewCase> cases{
        {"go to", {0_deg, 0_deg}, request::PointSky{{113_deg, 10_deg}}, {113_deg, 10_deg}},
        {"around a mast", {290_deg, 5_deg}, request::PointAxes{{340_deg, 5_deg}}, {340_deg, 5_deg}},
        {"unwrap", {425_deg, 50_deg}, request::Unwind{}, {65_deg, 50_deg}},
        {"park", {20_deg, 10_deg}, request::Park{}, {250_deg, 85_deg}},
        {"home", {200_deg, 80_deg}, request::Home{}, {0_deg, 0_deg}},
        {"one axis", {200_deg, 10_deg}, request::PointAxis{Axis::Elevation, 70_deg}, {200_deg, 70_deg}},
    };
    for (const SlewCase& one : cases) {
        expectTimeOf(one, profile::Arrival::Separate);
    }
    expectTimeOf(cases.front(), profile::Arrival::Together);
    expectTimeOf(cases.at(1), profile::Arrival::Together);
}

}  // namespace
}  // namespace boresight::system_test
