// SPDX-License-Identifier: GPL-3.0-or-later
// The cost of computing the directions of Sun and Moon, and of magnetic north.
#include "core/ephemeris/almanac.h"
#include "core/ephemeris/rise_set.h"
#include "core/geomagnetism/magnetic_model.h"

#include <benchmark/benchmark.h>

using namespace boresight;
using namespace boresight::ephemeris;

namespace {

constexpr Site kLisbon{.latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};
constexpr UtcTime kDay = std::chrono::sys_days{std::chrono::year{2026} / 12 / 24};

// From second to second, or from hour to hour, so that stored values do not help.
void place(benchmark::State& state, Body body, std::chrono::seconds step)
{
    Almanac almanac(kLisbon);
    UtcTime utc = kDay;
    for (auto _ : state) {
        benchmark::DoNotOptimize(almanac.place(body, utc));
        utc += step;
    }
}
BENCHMARK_CAPTURE(place, sun, Body::Sun, std::chrono::seconds(1));
BENCHMARK_CAPTURE(place, moon, Body::Moon, std::chrono::seconds(1));
BENCHMARK_CAPTURE(place, sunOfAnyTime, Body::Sun, std::chrono::hours(1));
BENCHMARK_CAPTURE(place, moonOfAnyTime, Body::Moon, std::chrono::hours(1));

void sunrise(benchmark::State& state)
{
    Almanac almanac(kLisbon);
    for (auto _ : state) {
        benchmark::DoNotOptimize(nextRise(almanac, Body::Sun, kDay, 0_deg));
    }
}
BENCHMARK(sunrise);

// The cost does not depend on the values of the terms.
void magneticField(benchmark::State& state)
{
    geomagnetism::Coefficients coefficients{.name = "bench", .epoch = 2025.0};
    coefficients.main.fill({100.0, 100.0});
    coefficients.change.fill({1.0, 1.0});
    const geomagnetism::MagneticModel model(coefficients);
    for (auto _ : state) {
        benchmark::DoNotOptimize(model.at(kLisbon, 2026.98));
    }
}
BENCHMARK(magneticField);

}  // namespace
