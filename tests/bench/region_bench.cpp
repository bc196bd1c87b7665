// SPDX-License-Identifier: GPL-3.0-or-later
//
// The speed of the permitted region, with a horizon of 360 points and ten keep-outs on a mount of nearly two turns that
// can go over the top. Measured are the queries of a control tick (a box, the room around it), those of a new target
// (the nearest permitted place, a route), and whole ticks of both axes, with and without forbidden areas. Also the
// largest cost that a profile can cause: 32 keep-outs around one target, and the band of the Sun when no time source
// sets the clock.

#include "core/motion/motion.h"
#include "core/pointing/nearest_permitted.h"
#include "core/pointing/route.h"
#include "core/pointing/sun_keep_out.h"
#include "core/profile/setting.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <ctime>
#include <random>
#include <string>

namespace {

using namespace boresight;
using namespace boresight::pointing;

Region drawn()
{
    Region region;
    for (int i = 0; i < 360; ++i) {
        const double wave = std::sin(i * 0.11) + std::sin(i * 0.031);
        region.horizon.push_back(
            {.azimuth = Angle::fromDegrees(i), .elevation = Angle::fromDegrees(15.0 + 7.0 * wave)});
    }
    for (int i = 0; i < 10; ++i) {
        region.keepOuts.push_back({.name = "mast " + std::to_string(i),
                                   .azimuthFrom = Angle::fromDegrees(36.0 * i),
                                   .azimuthTo = Angle::fromDegrees(36.0 * i + 20.0),
                                   .elevationMin = Angle::fromDegrees(i % 2 == 0 ? 0.0 : 30.0),
                                   .elevationMax = Angle::fromDegrees(i % 2 == 0 ? 50.0 : 85.0)});
    }
    return region;
}

const PointingModel kLeaning({.tiltNorth = 0.5_deg, .tiltEast = 0.3_deg, .collimation = 0.3_deg});

const PermittedRegion& region()
{
    static const PermittedRegion prepared(drawn(), {-200_deg, 460_deg}, {0_deg, 180_deg});
    return prepared;
}

const PermittedRegion& leaningRegion()
{
    static const PermittedRegion prepared(drawn(), {-200_deg, 460_deg}, {0_deg, 180_deg}, kLeaning);
    return prepared;
}

Region crowded(std::mt19937& random)
{
    const auto degrees = [&](double from, double to) {
        return Angle::fromDegrees(std::uniform_real_distribution<double>(from, to)(random));
    };
    Region region = withSun({.horizon = drawn().horizon}, sunBand(48_deg, 10_deg));
    for (std::size_t i = 0; i < profile::kMaxKeepOuts; ++i) {
        const Angle azimuth = 20_deg + degrees(-12, 10);
        const Angle elevation = 45_deg + degrees(-12, 10);
        region.keepOuts.push_back({.name = std::to_string(i),
                                   .azimuthFrom = azimuth,
                                   .azimuthTo = azimuth + degrees(1, 4),
                                   .elevationMin = elevation,
                                   .elevationMax = elevation + degrees(1, 4)});
    }
    return region;
}

AxisPosition place(std::mt19937& random)
{
    return {.azimuth = Angle::fromDegrees(std::uniform_real_distribution<double>(-200, 460)(random)),
            .elevation = Angle::fromDegrees(std::uniform_real_distribution<double>(0, 180)(random))};
}

AxisPosition permittedPlace(std::mt19937& random, const PermittedRegion& within = region())
{
    return *pointing::nearestPermitted(within, place(random));
}

void prepare(benchmark::State& state)
{
    const Region plan = drawn();
    for (auto _ : state) {
        benchmark::DoNotOptimize(PermittedRegion(plan, {-200_deg, 460_deg}, {0_deg, 180_deg},
                                                 state.range(0) != 0 ? kLeaning : PointingModel()));
    }
}
BENCHMARK(prepare)->Arg(0)->Arg(1);

void permitsABox(benchmark::State& state)
{
    std::mt19937 random(1);
    const AxisPosition here = permittedPlace(random);
    const AxisBox box = AxisBox::between(here, {here.azimuth + 2_deg, here.elevation + 2_deg});
    for (auto _ : state) {
        benchmark::DoNotOptimize(region().permits(box));
    }
}
BENCHMARK(permitsABox);

void roomAroundABox(benchmark::State& state)
{
    std::mt19937 random(1);
    const AxisBox box = AxisBox::at(permittedPlace(random));
    for (auto _ : state) {
        benchmark::DoNotOptimize(region().azimuthsAround(box));
        benchmark::DoNotOptimize(region().elevationsAround(box));
    }
}
BENCHMARK(roomAroundABox);

void nearestPlace(benchmark::State& state)
{
    std::mt19937 random(1);
    for (auto _ : state) {
        benchmark::DoNotOptimize(pointing::nearestPermitted(region(), place(random)));
    }
}
BENCHMARK(nearestPlace);

void routeBetweenAny(benchmark::State& state)
{
    const PermittedRegion& within = state.range(0) != 0 ? leaningRegion() : region();
    std::mt19937 random(1);
    double worst = 0.0;
    for (auto _ : state) {
        const AxisPosition from = permittedPlace(random, within);
        const AxisPosition to = permittedPlace(random, within);
        const std::clock_t start = std::clock();
        benchmark::DoNotOptimize(route(within, from, to, {10_deg_s, 8_deg_s}));
        worst = std::max(worst, 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    state.counters["worst_cpu_ms"] = worst;
}
BENCHMARK(routeBetweenAny)->Arg(0)->Arg(1);  // for an upright mount, for a leaning one

// From any place to the middle of them: the worst case for preparing, for a nearest place and for a route.
void mostKeepOuts(benchmark::State& state)
{
    const PointingModel model = state.range(0) != 0 ? kLeaning : PointingModel();
    std::mt19937 random(1);
    double prepared = 0.0;
    double nearest = 0.0;
    double routed = 0.0;
    const auto timed = [](double& worst, auto&& work) {
        const std::clock_t start = std::clock();
        auto result = work();
        worst = std::max(worst, 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
        return result;
    };
    for (auto _ : state) {
        const Region plan = crowded(random);
        const auto within = timed(prepared, [&] {
            return PermittedRegion(plan, {-200_deg, 460_deg}, {0_deg, 180_deg}, model);
        });
        const AxisPosition from = permittedPlace(random, within);
        const AxisPosition to = *timed(nearest, [&] { return pointing::nearestPermitted(within, {20_deg, 45_deg}); });
        benchmark::DoNotOptimize(timed(routed, [&] { return route(within, from, to, {10_deg_s, 8_deg_s}); }));
    }
    state.counters["worst_layout_ms"] = prepared;
    state.counters["worst_nearest_ms"] = nearest;
    state.counters["worst_route_ms"] = routed;
}
BENCHMARK(mostKeepOuts)->Arg(0)->Arg(1);

void tickOfBothAxes(benchmark::State& state)
{
    profile::Profile profile;
    profile.azimuth.geometry.travel = {-200_deg, 460_deg};
    profile.elevation.geometry.travel = {0_deg, 180_deg};
    profile.limits = state.range(0) != 0 ? drawn() : Region{};
    Motion motion(profile);
    motion.start(Axis::Azimuth, 100_deg);
    motion.start(Axis::Elevation, 88_deg);
    SteadyTime now{};
    std::int64_t tick = 0;
    for (auto _ : state) {
        if (tick++ % 500 == 0) {
            const double way = tick / 500 % 2 == 0 ? 1.0 : -1.0;
            motion.run({AngularRate::fromDegrees(5.0 * way), AngularRate::fromDegrees(0.3 * way)});
        }
        now += std::chrono::milliseconds(20);
        motion.advance(now, Seconds(0.02));
    }
}
BENCHMARK(tickOfBothAxes)->Arg(0)->Arg(1);

}  // namespace
