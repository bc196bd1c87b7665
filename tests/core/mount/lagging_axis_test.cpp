// SPDX-License-Identifier: GPL-3.0-or-later
// A rotator that turns more slowly than its profile says, near a keep-out. Its axes run independently, each at its own
// speed.
#include "tests/core/gs232_mount/gs232_bench.h"
#include "tests/core/mount/mount_bench.h"
#include "tests/core/rotctld_mount/rotctld_bench.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace boresight {
namespace {

struct LaggingKind
{
    const char* name;
    profile::Profile (*profile)();
    std::function<std::unique_ptr<Bench>(const profile::Profile&)> make;
};

const pointing::KeepOut kMast{
    .name = "mast", .azimuthFrom = 100_deg, .azimuthTo = 120_deg, .elevationMin = 0_deg, .elevationMax = 30_deg};

// REQ-MOUNT-16 (LaggingAxis.*): A rotator with one or both axes slower than the profile says enters no keep-out. Its
// set-points wait while the way to them from its real position is not free. It still reaches its targets. If the edge
// of a keep-out is moved into its way it stops.
class LaggingAxis : public testing::TestWithParam<LaggingKind>
{
protected:
    void begin(const std::vector<pointing::KeepOut>& keepOuts)
    {
        m_profile = GetParam().profile();
        m_profile.limits.keepOuts = keepOuts;
        m_profile.mount.beamWidth = beamWidth;
        bench = GetParam().make(m_profile);
        bench->run(Seconds(2.0));
    }
    // Runs, and checks that the rotator is never deeper inside a keep-out than its position error.
    void runOutside(Seconds time)
    {
        constexpr Angle kMiss = Angle::fromDegrees(1.5);
        for (Seconds left = time; left > Seconds(0.0); left -= kOneTick) {
            bench->tick();
            const AxisPosition at = bench->truth();
            const bool inside = at.azimuth > kMast.azimuthFrom + kMiss && at.azimuth < kMast.azimuthTo - kMiss &&
                                at.elevation < kMast.elevationMax - kMiss;
            ASSERT_FALSE(inside) << at.azimuth.degrees() << "° " << at.elevation.degrees() << "°";
        }
    }
    void follow(double azimuth, double elevation)
    {
        ASSERT_TRUE(bench->control().request(
            request::PointAxes{{Angle::fromDegrees(azimuth), Angle::fromDegrees(elevation)}}, kClient));
        runOutside(Seconds(1.0));
    }

    Angle beamWidth = 10_deg;
    profile::Profile m_profile;
    std::unique_ptr<Bench> bench;
};

TEST_P(LaggingAxis, FollowsAPathOverAKeepOut)
{
    begin({kMast});
    for (int second = 0; second < 25; ++second) {
        follow(90.0, 35.0);
    }
    bench->setPace({1.0 / 6.0, 1.0});
    for (double azimuth = 90.0; azimuth < 125.0 && !HasFatalFailure(); azimuth += 3.5) {
        follow(azimuth, 35.0);
    }
    for (double elevation = 35.0; elevation > 10.0 && !HasFatalFailure(); elevation -= 2.5) {
        follow(125.0, elevation);
    }
    for (int second = 0; second < 40 && !HasFatalFailure(); ++second) {
        follow(125.0, 10.0);
    }
    bench->expectAt({125_deg, 10_deg}, {}, 1_deg);
    EXPECT_FALSE(bench->control().faultLatched());
}

// REQ-MOUNT-18: A wide dead-band leads into no keep-out either, nor does its lead.
TEST_P(LaggingAxis, IsNotLedIntoAKeepOut)
{
    struct Approach
    {
        AxisPosition from;
        double azimuth;  // ° each second
        double elevation;
    };
    beamWidth = 40_deg;
    for (const Approach& way : {Approach{{140_deg, 12_deg}, -0.5, 0.0}, Approach{{80_deg, 12_deg}, 0.5, 0.0},
                                Approach{{110_deg, 50_deg}, 0.0, -0.5}, Approach{{90_deg, 36_deg}, 0.5, -0.1},
                                Approach{{132_deg, 40_deg}, -0.3, -0.4}}) {
        begin({kMast});
        for (int second = -30; second < 50 && !HasFatalFailure(); ++second) {
            const double time = std::max(second, 0);
            follow(way.from.azimuth.degrees() + way.azimuth * time,
                   way.from.elevation.degrees() + way.elevation * time);
        }
        EXPECT_FALSE(bench->control().faultLatched());
    }
}

TEST_P(LaggingAxis, GoesAroundAKeepOut)
{
    for (const std::array<double, 2>& pace : {std::array{1.0 / 6.0, 1.0}, std::array{1.0, 1.0 / 6.0}}) {
        begin({kMast});
        ASSERT_TRUE(bench->goTo(80.0, 10.0));
        bench->run(Seconds(30.0));
        bench->setPace(pace);
        ASSERT_TRUE(bench->goTo(140.0, 10.0));
        runOutside(Seconds(90.0));
        bench->expectAt({140_deg, 10_deg}, {}, 1_deg);
        EXPECT_FALSE(bench->control().faultLatched());
    }
}

// The set-points have long arrived, and the rotator is far behind them.
TEST_P(LaggingAxis, StopsForAKeepOutThatIsDrawnIntoItsWay)
{
    begin({});
    ASSERT_TRUE(bench->goTo(80.0, 10.0));
    bench->run(Seconds(30.0));
    bench->setPace({1.0 / 6.0, 1.0});
    ASSERT_TRUE(bench->goTo(140.0, 10.0));
    bench->run(Seconds(15.0));
    ASSERT_LT(bench->truth().azimuth, 98_deg);
    m_profile.limits.keepOuts = {kMast};
    bench->edit(m_profile);
    runOutside(Seconds(110.0));
    bench->expectAt({140_deg, 10_deg}, {}, 1_deg);
    EXPECT_FALSE(bench->control().faultLatched());
}

// REQ-MOUNT-17 (LaggingAxis.Hold*, LaggingAxis.TheEndOfAJog*): Hold and the end of a jog stop such a rotator where it
// is. It does not run on to its set-points, which are far ahead.
TEST_P(LaggingAxis, HoldStopsItWhereItIs)
{
    begin({});
    ASSERT_TRUE(bench->goTo(80.0, 10.0));
    bench->run(Seconds(30.0));
    bench->setPace({1.0 / 6.0, 1.0});
    ASSERT_TRUE(bench->goTo(140.0, 10.0));
    bench->run(Seconds(14.0));
    ASSERT_TRUE(bench->control().request(request::Hold{}, kOperator));
    bench->run(Seconds(1.5));
    const AxisPosition held = bench->truth();
    EXPECT_LT(held.azimuth, 100_deg);
    bench->run(Seconds(30.0));
    EXPECT_LT(abs(bench->truth().azimuth - held.azimuth), 1_deg);
    EXPECT_FALSE(bench->control().faultLatched());
    ASSERT_TRUE(bench->goTo(90.0, 12.0));
    bench->run(Seconds(30.0));
    bench->expectAt({90_deg, 12_deg}, {}, 1_deg);
}

TEST_P(LaggingAxis, TheEndOfAJogStopsItWhereItIs)
{
    begin({});
    ASSERT_TRUE(bench->goTo(80.0, 10.0));
    bench->run(Seconds(30.0));
    bench->setPace({1.0 / 6.0, 1.0});
    for (int i = 0; i < 50; ++i) {
        ASSERT_TRUE(bench->control().request(request::Jog{{.azimuth = 6_deg_s}}, kOperator));
        bench->run(Seconds(0.1));
    }
    ASSERT_TRUE(bench->control().request(request::Hold{}, kOperator));
    bench->run(Seconds(4.0));
    const AxisPosition held = bench->truth();
    EXPECT_LT(held.azimuth, 92_deg);
    bench->run(Seconds(20.0));
    EXPECT_LT(abs(bench->truth().azimuth - held.azimuth), 1_deg);
    EXPECT_FALSE(bench->control().faultLatched());
}

// A rotator that was stopped inside a keep-out can leave it.
TEST_P(LaggingAxis, LeavesAKeepOut)
{
    begin({});
    ASSERT_TRUE(bench->goTo(108.0, 10.0));
    bench->run(Seconds(40.0));
    bench->setPace({1.0 / 6.0, 1.0});
    m_profile.limits.keepOuts = {kMast};
    bench->edit(m_profile);
    bench->run(Seconds(2.0));
    ASSERT_TRUE(bench->goTo(80.0, 10.0));
    bench->run(Seconds(60.0));
    bench->expectAt({80_deg, 10_deg}, {}, 1_deg);
    EXPECT_FALSE(bench->control().faultLatched());
}

profile::Profile rareRotctldProfile()
{
    profile::Profile profile = rotctl::rotctldProfile();
    profile.rotator.rareStarts = profile::RareStarts::On;
    return profile;
}

std::unique_ptr<Bench> makeGs232(const profile::Profile& profile)
{
    return std::make_unique<gs232::Gs232Bench>(profile);
}

std::unique_ptr<Bench> makeRotctld(const profile::Profile& profile)
{
    return std::make_unique<rotctl::RotctldBench>(profile);
}

INSTANTIATE_TEST_SUITE_P(Boxes, LaggingAxis,
                         testing::Values(LaggingKind{"Gs232", [] { return gs232::gs232Profile(); }, makeGs232},
                                         LaggingKind{"Gs232RareStarts", [] { return gs232::switchedProfile(); },
                                                     makeGs232},
                                         LaggingKind{"Rotctld", [] { return rotctl::rotctldProfile(); }, makeRotctld},
                                         LaggingKind{"RotctldRareStarts", rareRotctldProfile, makeRotctld}),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace boresight
