// SPDX-License-Identifier: GPL-3.0-or-later
// REQ-CALIBRATION-08 (tests/bench/run swing)
//
// swing_statistics [MOUNTS [SEED]]: the errors of north and tilt after a compass swing, and how often they are within
// the displayed sigmas, for random mounts (tests/fakes/swung_mount.h): over the wide range of the requirement, with the
// iron of real places, over a part of the circle, and in one direction only. One line each.

#include "tests/fakes/swung_mount.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

using namespace boresight;
using namespace boresight::calibration;

constexpr int kMounts = 1000;
constexpr unsigned long kSwingStatisticsSeed = 5;

struct Errors
{
    std::vector<double> off;  // degrees
    std::vector<double> sigma;

    void add(Angle error, Angle shown)
    {
        off.push_back(std::abs(error.wrapped180().degrees()));
        sigma.push_back(shown.degrees());
    }
    [[nodiscard]] double rms() const
    {
        double square = 0.0;
        for (const double one : off) {
            square += one * one;
        }
        return std::sqrt(square / static_cast<double>(off.size()));
    }
    // Percentage within this number of sigmas.
    [[nodiscard]] double within(double sigmas) const
    {
        int inside = 0;
        for (std::size_t i = 0; i < off.size(); ++i) {
            inside += off[i] < sigmas * sigma[i] ? 1 : 0;
        }
        return 100.0 * inside / static_cast<double>(off.size());
    }
    [[nodiscard]] double below(double limit) const
    {
        const auto count = std::count_if(off.begin(), off.end(), [&](double one) { return one < limit; });
        return 100.0 * static_cast<double>(count) / static_cast<double>(off.size());
    }
    [[nodiscard]] double worst() const { return *std::max_element(off.begin(), off.end()); }
    [[nodiscard]] double meanSigma() const
    {
        double sum = 0.0;
        for (const double one : sigma) {
            sum += one;
        }
        return sum / static_cast<double>(sigma.size());
    }
};

void print(const char* what, const Errors& errors, double limit)
{
    std::printf(
        "  %-22s rms %5.3f°  worst %5.3f°  below %g° %5.1f %%  within 1σ %5.1f %%  2σ %5.1f %%  mean σ %5.3f°\n", what,
        errors.rms(), errors.worst(), limit, errors.below(limit), errors.within(1.0), errors.within(2.0),
        errors.meanSigma());
}

void measure(const char* title, fakes::Needle needle, const fakes::SwingPlan& plan, int mounts, unsigned long seed)
{
    std::mt19937_64 random(seed);
    Errors north;
    Errors readingsOnly;
    Errors tilt;
    int refused = 0;
    int hopeless = 0;
    for (int i = 0; i < mounts; ++i) {
        const fakes::SwungMount mount = fakes::randomMount(random, needle);
        const fakes::Swung swung = fakes::swing(mount, random, plan);
        const auto swing = fitCompassSwing(swung.samples);
        if (!swing) {
            ++refused;
            continue;
        }
        hopeless += swing->isUsable() ? 0 : 1;
        const Angle error = swing->north.value - mount.terms.azimuthOffset;
        north.add(error, swing->north.sigma);
        readingsOnly.add(error, swing->statistical);
        if (const auto level = fitAxisTilt(swung.levels, swing->north)) {
            tilt.add(level->north.value - mount.terms.tiltNorth, level->north.sigma);
            tilt.add(level->east.value - mount.terms.tiltEast, level->east.sigma);
        }
    }
    std::printf("%s: %d mounts, %d refused, %d called hopeless\n", title, mounts, refused, hopeless);
    print("north", north, 2.0);
    print("north, readings' σ", readingsOnly, 2.0);
    print("tilt, north and east", tilt, 0.1);
}

}  // namespace

int main(int argc, char** argv)
{
    const int mounts = argc > 1 ? std::atoi(argv[1]) : kMounts;
    const unsigned long seed = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : kSwingStatisticsSeed;
    if (mounts <= 0) {
        std::fprintf(stderr, "swing_statistics [MOUNTS [SEED]]\n");
        return 2;
    }
    measure("harmonics of up to 8° and 3°", fakes::Needle::Harmonics, {}, mounts, seed);
    measure("iron, box askew", fakes::Needle::Iron, {}, mounts, seed);
    measure("harmonics, one way", fakes::Needle::Harmonics, {.back = false}, mounts, seed);
    measure("harmonics, 300° of azimuth", fakes::Needle::Harmonics, {.from = 0.0, .to = 300.0}, mounts, seed);
    measure("harmonics, 240° of azimuth", fakes::Needle::Harmonics, {.from = 0.0, .to = 240.0}, mounts, seed);
    return 0;
}
