// SPDX-License-Identifier: GPL-3.0-or-later
// How deep a rotator that coasts, or whose potentiometers are worn, gets into a keep-out: with rare motor starts, and
// when each step is sent.
#include "tests/core/gs232_mount/gs232_bench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <random>

namespace boresight::gs232 {
namespace {

const pointing::KeepOut kChimney{
    .name = "chimney", .azimuthFrom = 100_deg, .azimuthTo = 130_deg, .elevationMin = 0_deg, .elevationMax = 30_deg};

struct Case
{
    const char* name;
    bool worn;
    Angle coast;
};

struct Depth
{
    Angle deepest{};
    int mostStarts = 0;  // of both motors in a minute
};

Angle depthAt(const AxisPosition& place)
{
    return std::max(Angle{}, std::min({place.azimuth - kChimney.azimuthFrom, kChimney.azimuthTo - place.azimuth,
                                       kChimney.elevationMax - place.elevation}));
}

// A target that moves to and fro around an edge, and through the keep-out.
class RandomTarget
{
public:
    explicit RandomTarget(unsigned seed) : m_random(seed) {}

    AxisPosition after(double seconds)
    {
        if (m_left <= 0.0) {
            m_left = 5.0 + 15.0 * share();
            m_rates = {3.0 * share() - 1.5, 2.0 * share() - 1.0};
        }
        m_left -= seconds;
        m_azimuth = std::clamp(m_azimuth + m_rates[0] * seconds, 80.0, 150.0);
        m_elevation = std::clamp(m_elevation + m_rates[1] * seconds, 10.0, 50.0);
        return {.azimuth = Angle::fromDegrees(m_azimuth), .elevation = Angle::fromDegrees(m_elevation)};
    }

private:
    double share() { return static_cast<double>(m_random() % 1000U) / 1000.0; }

    std::mt19937 m_random;
    double m_left = 0.0;
    std::array<double, 2> m_rates{};
    double m_azimuth = 90.0;
    double m_elevation = 36.0;
};

Depth run(const Case& one, profile::RareStarts rareStarts, unsigned seed)
{
    profile::Profile profile = gs232Profile();
    profile.mount.beamWidth = 20_deg;
    profile.limits.keepOuts = {kChimney};
    profile.rotator.rareStarts = rareStarts;
    Gs232Bench bench(profile);
    bench.box().faults().worn = one.worn;
    bench.box().faults().coast = one.coast;
    bench.run(Seconds(2.0));
    RandomTarget target(seed);
    EXPECT_TRUE(bench.control().request(request::PointAxes{target.after(0.0)}, kClient));
    bench.run(Seconds(30.0));
    Depth depth;
    for (int minute = 0; minute < 3; ++minute) {
        const int starts = bench.box().starts();
        for (int part = 0; part < 60; ++part) {
            EXPECT_TRUE(bench.control().request(request::PointAxes{target.after(1.0)}, kClient));
            for (int look = 0; look < 10; ++look) {
                bench.run(Seconds(0.1));
                depth.deepest = std::max(depth.deepest, depthAt(bench.truth()));
            }
        }
        depth.mostStarts = std::max(depth.mostStarts, bench.box().starts() - starts);
    }
    return depth;
}

// REQ-GS232-64: With rare motor starts an axis gets at most one step of the box deeper into a keep-out than without
// them, and its motors start no more often beside it.
TEST(SwitchedMotorDepth, IsAtMostAStepDeeperThanWithoutRareStarts)
{
    constexpr unsigned kRuns = 6;
    for (const Case& one : {Case{"coast 0.5°", false, 0.5_deg}, Case{"coast 1.5°", false, 1.5_deg},
                            Case{"worn", true, 0.5_deg}, Case{"worn, coast 1.5°", true, 1.5_deg}}) {
        Depth rare;
        Depth each;
        for (unsigned seed = 1; seed <= kRuns; ++seed) {
            const Depth with = run(one, profile::RareStarts::On, seed);
            const Depth without = run(one, profile::RareStarts::Off, seed);
            rare = {std::max(rare.deepest, with.deepest), std::max(rare.mostStarts, with.mostStarts)};
            each = {std::max(each.deepest, without.deepest), std::max(each.mostStarts, without.mostStarts)};
        }
        std::cout << "| " << one.name << " | rare: " << rare.deepest.degrees() << "°, " << rare.mostStarts
                  << " starts | each step: " << each.deepest.degrees() << "°, " << each.mostStarts << " starts |\n";
        EXPECT_LE(rare.deepest, each.deepest + Angle::fromDegrees(1.1)) << one.name;
        EXPECT_LE(rare.mostStarts, each.mostStarts) << one.name;
    }
}

}  // namespace
}  // namespace boresight::gs232
