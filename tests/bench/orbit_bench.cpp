// SPDX-License-Identifier: GPL-3.0-or-later
//
// The speed of satellite computations on one core: propagations near the Earth and in deep space, from minute to minute
// over days as in a search for passes, also with the direction in the sky, and the step from the two lines of a set to
// the orbit. Beside each figure is that of the published C++ (AIAA 2006-6753) at -O2 on one core of a server. The
// passes of 100 satellites over ten days are also shown as the number of low-orbit propagations that take the same
// time. The best published figure, 0.26 s on that core, equals 1.01 million of them.

#include "core/elements/element_reader.h"
#include "core/elements/tle_fields.h"
#include "core/orbit/sgp4.h"
#include "core/orbit/topocentric.h"
#include "core/passes/pass_scan.h"

#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <ctime>
#include <random>
#include <string>
#include <vector>

using namespace boresight;
using namespace boresight::orbit;

namespace {

constexpr Site kLisbon{.latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};
constexpr std::string_view kFirstLine = "1 25544U 98067A   24130.36689744  .00016024  00000+0  27777-3 0  9992";
constexpr std::string_view kSecondLine = "2 25544  51.6381 147.8590 0003466 150.4670 338.5502 15.51043222452521";
constexpr const char* kPublishedNear = "published C++: 3.9 M/s";
constexpr const char* kPublishedDeep = "published C++: 2.6 M/s";
constexpr const char* kPublishedInit = "published C++: 2.2 us";

ElementSet lowOrbit()
{
    return parseTle(kFirstLine, kSecondLine).value();
}

ElementSet deepOrbit(double revolutionsPerDay, double eccentricity, Angle inclination)
{
    return {.epoch = julianDate(2024, 129.0),
            .revolutionsPerDay = revolutionsPerDay,
            .eccentricity = eccentricity,
            .inclination = inclination,
            .ascendingNode = 1.1841_deg,
            .perigee = 273.809_deg,
            .meanAnomaly = 305.2438_deg};
}

// A navigation satellite with 12 hours and no resonance, a half-day orbit of the Molniya type, and a geostationary
// orbit.
ElementSet navigationOrbit()
{
    return deepOrbit(2.0056, 0.01, 55_deg);
}

ElementSet halfDayOrbit()
{
    return deepOrbit(2.00646267, 0.7150722, 63.5864_deg);
}

ElementSet oneDayOrbit()
{
    return deepOrbit(1.00272844, 0.0002053, 0.0227_deg);
}

double nextMinute(double minutes)
{
    constexpr double kDays = 3.0;
    return std::fmod(minutes + 1.0, kDays * kMinutesPerDay);
}

void propagation(benchmark::State& state, const ElementSet& elements, const char* published)
{
    const Sgp4 orbit(elements);
    ResonanceState resonance;
    double minutes = 0.0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(orbit.propagate(minutes, resonance));
        minutes = nextMinute(minutes);
    }
    state.SetItemsProcessed(state.iterations());
    state.SetLabel(published);
}
BENCHMARK_CAPTURE(propagation, nearEarth, lowOrbit(), kPublishedNear);
BENCHMARK_CAPTURE(propagation, deepSpace, navigationOrbit(), kPublishedDeep);
BENCHMARK_CAPTURE(propagation, halfDayResonance, halfDayOrbit(), kPublishedDeep);
BENCHMARK_CAPTURE(propagation, oneDayResonance, oneDayOrbit(), kPublishedDeep);

void skyPlace(benchmark::State& state)
{
    const Sgp4 orbit(lowOrbit());
    const Observer observer(kLisbon);
    double minutes = 0.0;
    for (auto _ : state) {
        const JulianDate utc{.day = orbit.epoch().day + minutes / kMinutesPerDay, .fraction = orbit.epoch().fraction};
        const OrbitResult place = orbit.propagate(utc);
        benchmark::DoNotOptimize(observer.look(groundState(place.value_or(OrbitState{}), utc)));
        minutes = nextMinute(minutes);
    }
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(skyPlace);

void linesToOrbit(benchmark::State& state)
{
    for (auto _ : state) {
        const auto elements = parseTle(kFirstLine, kSecondLine);
        benchmark::DoNotOptimize(Sgp4(elements.value()));
    }
    state.SetLabel(kPublishedInit);
}
BENCHMARK(linesToOrbit);

void deepElementsToOrbit(benchmark::State& state)
{
    const ElementSet elements = halfDayOrbit();
    for (auto _ : state) {
        benchmark::DoNotOptimize(Sgp4(elements));
    }
}
BENCHMARK(deepElementsToOrbit);

void fileOfThousandSets(benchmark::State& state)
{
    std::string text;
    for (int i = 0; i < 1000; ++i) {
        text.append("NAME\n").append(kFirstLine).append("\n").append(kSecondLine).append("\n");
    }
    for (auto _ : state) {
        benchmark::DoNotOptimize(readElements(text));
    }
    state.SetItemsProcessed(state.iterations() * 1000);
}
BENCHMARK(fileOfThousandSets);

// 89 low orbits and 11 in deep space, a mixture as in a catalogue.
std::vector<Sgp4> catalogue()
{
    std::mt19937 random(1);
    const auto draw = [&random](double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(random);
    };
    std::vector<Sgp4> orbits;
    for (int i = 0; i < 100; ++i) {
        ElementSet set = i < 89   ? deepOrbit(draw(12.5, 15.8), draw(1e-4, 0.02), Angle::fromDegrees(draw(45.0, 100.0)))
                         : i < 94 ? deepOrbit(1.0027, 2e-4, Angle::fromDegrees(draw(0.0, 5.0)))
                                  : deepOrbit(2.006, draw(0.01, 0.72), Angle::fromDegrees(draw(55.0, 64.0)));
        set.ascendingNode = Angle::fromDegrees(draw(0.0, 360.0));
        set.meanAnomaly = Angle::fromDegrees(draw(0.0, 360.0));
        orbits.emplace_back(set);
    }
    return orbits;
}

// Processor time, independent of other load.
double processorSeconds()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double secondsOfOneLowPropagation()
{
    constexpr int kCount = 300'000;
    const Sgp4 orbit(lowOrbit());
    const double begin = processorSeconds();
    for (int i = 0; i < kCount; ++i) {
        benchmark::DoNotOptimize(orbit.propagate(static_cast<double>(i % 4320)));
    }
    return (processorSeconds() - begin) / kCount;
}

void passesOfTenDays(benchmark::State& state)
{
    const std::vector<Sgp4> orbits = catalogue();
    const UtcTime from = utcTime(orbits.front().epoch());
    const passes::PassSearch search{.site = kLisbon, .from = from, .to = from + std::chrono::days(10)};
    const double unit = secondsOfOneLowPropagation();
    std::size_t found = 0;
    long propagations = 0;
    const double begin = processorSeconds();
    for (auto _ : state) {
        found = 0;
        propagations = 0;
        for (const Sgp4& orbit : orbits) {
            passes::PassScan scan(orbit, search);
            found += scan.run({}).passes.size();
            propagations += scan.propagations();
        }
    }
    const double seconds = processorSeconds() - begin;
    state.counters["passes"] = static_cast<double>(found);
    state.counters["calls"] = static_cast<double>(propagations);
    state.counters["as_long_as"] = seconds / static_cast<double>(state.iterations()) / unit;
    state.SetLabel("published: 0.26 s, as long as 1.01 M");
}
BENCHMARK(passesOfTenDays)->Unit(benchmark::kMillisecond);

}  // namespace
