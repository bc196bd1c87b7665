// SPDX-License-Identifier: GPL-3.0-or-later
//
// How fast satellites are computed, on one core: propagations near the Earth and in deep space, each from minute to
// minute over days as a search of passes asks for them, and with the place in the sky; and from the two lines of a set
// to the orbit. Beside each figure stands that of the published C++ (AIAA 2006-6753) at -O2 on one core of a server.

#include "core/elements/element_reader.h"
#include "core/elements/tle_fields.h"
#include "core/orbit/sgp4.h"
#include "core/orbit/topocentric.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

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

// 12 hours of a navigation satellite, which have no resonance; half a day of Molniya's kind; a geostationary day.
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

}  // namespace
