// SPDX-License-Identifier: GPL-3.0-or-later
//
// How long it takes to find the target of a client among 10,000 satellites: by five points along its path, and by one
// point where it waits for the rise. The station does this on another thread. At most 50 ms are permitted.

#include "core/passes/pass_finder.h"
#include "core/recognise/recognise.h"
#include "tests/core/recognise/client_points.h"

#include <benchmark/benchmark.h>

#include <algorithm>

using namespace boresight;

namespace {

constexpr Site kLisbon{.latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};
constexpr int kSatellites = 10'000;
const UtcTime kNow = UtcTime(std::chrono::seconds(1'790'000'000));

struct Pass
{
    targets::Target target;
    passes::Pass pass;
};

// The next pass of the first satellite that has one soon.
Pass firstPass(const recognise::SharedSatellites& satellites)
{
    for (const orbit::ElementSet& set : *satellites) {
        const auto list = passes::findPasses(
            orbit::Sgp4(set), {.site = kLisbon, .from = kNow, .to = kNow + std::chrono::hours(2), .isClear = {}});
        if (!list.passes.empty() && list.passes.front().aos.utc > kNow) {
            return {.target = targets::satelliteTarget(set), .pass = list.passes.front()};
        }
    }
    return {};
}

void measure(benchmark::State& state, const recognise::SentPoints& points, const recognise::SharedSatellites& all)
{
    for (auto _ : state) {
        benchmark::DoNotOptimize(recognise::recognise(points, {.satellites = all, .site = kLisbon}));
    }
}

void movingPoints(benchmark::State& state)
{
    const auto all = fakes::manySatellites(kSatellites, kNow);
    const Pass pass = firstPass(all);
    measure(state, fakes::pointsOf(pass.target, kLisbon, pass.pass.aos.utc + std::chrono::minutes(1), 5), all);
}
BENCHMARK(movingPoints)->Unit(benchmark::kMillisecond);

void pointAtTheRise(benchmark::State& state)
{
    const auto all = fakes::manySatellites(kSatellites, kNow);
    const Pass pass = firstPass(all);
    const SkyPointing rise{.azimuth = pass.pass.aos.direction.azimuth, .elevation = {}};
    measure(state, {{.utc = pass.pass.aos.utc - std::chrono::minutes(4), .direction = rise}}, all);
}
BENCHMARK(pointAtTheRise)->Unit(benchmark::kMillisecond);

}  // namespace
