// SPDX-License-Identifier: GPL-3.0-or-later
// REQ-CALIBRATION-17 (tests/bench/run sun)
// REQ-CALIBRATION-17a (tests/bench/run sun)
//
// sun_statistics [RUNS [SEED]]: the accuracy of the pointing model after several points of the Sun, for random days and
// places (tests/fakes/sun_points.h), with the tilt known to 0.05° from a swing. It prints north (the largest azimuth
// error of a level beam all round), the largest error of the beam along the Sun's path, the rms error over the sky, and
// the terms. One line for each noise of centring and number of points, then the same with every third point taken over
// the top.

#include "core/calibration/pointing_fit.h"
#include "tests/fakes/sun_points.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

using namespace boresight;
using namespace boresight::calibration;

constexpr int kRuns = 300;
constexpr unsigned long kSeed = 5;
constexpr double kTiltOfSwing = 0.05;

struct Distribution
{
    std::vector<double> values;

    void add(double value) { values.push_back(std::abs(value)); }
    [[nodiscard]] double below(double limit) const
    {
        const auto count = std::count_if(values.begin(), values.end(), [&](double one) { return one < limit; });
        return 100.0 * static_cast<double>(count) / static_cast<double>(values.size());
    }
    [[nodiscard]] double percentile(double percent)
    {
        std::sort(values.begin(), values.end());
        return values[static_cast<std::size_t>(percent / 100.0 * static_cast<double>(values.size() - 1))];
    }
};

TermKnowledge afterSwing(const pointing::PointingTerms& truth, std::mt19937_64& random)
{
    std::normal_distribution<double> off(0.0, kTiltOfSwing);
    TermKnowledge known = TermKnowledge::usual();
    for (const Term term : {Term::TiltNorth, Term::TiltEast}) {
        known.of(term) = {valueOf(truth, term) + Angle::fromDegrees(off(random)), Angle::fromDegrees(kTiltOfSwing)};
    }
    return known;
}

void measure(double noise, int count, fakes::Sides sides, int runs, unsigned long seed)
{
    std::mt19937_64 random(seed);
    Distribution north;
    Distribution onArc;
    Distribution overSky;
    Distribution offset;
    Distribution tilt;
    Distribution inSigmas;
    for (int run = 0; run < runs; ++run) {
        const pointing::PointingTerms truth = fakes::randomHidden(random);
        const fakes::SunDay day = fakes::randomDay(random);
        const TermKnowledge known = afterSwing(truth, random);
        const auto points = fakes::sunPoints(truth, day, count, noise, random, sides);
        pointing::PointingTerms before;
        before.tiltNorth = known.of(Term::TiltNorth)->value;
        before.tiltEast = known.of(Term::TiltEast)->value;
        const auto fit = fitPointing(points, before, known);
        if (!fit) {
            continue;
        }
        const Estimate found = fit->of(Term::AzimuthOffset).estimate;
        const Angle error = (found.value - truth.azimuthOffset).wrapped180();
        north.add(fakes::northError(truth, fit->terms));
        onArc.add(fakes::worstOnArc(truth, fit->terms, day));
        overSky.add(fakes::rmsOverSky(truth, fit->terms));
        offset.add(error.degrees());
        inSigmas.add(error / found.sigma);
        tilt.add(std::hypot((fit->terms.tiltNorth - truth.tiltNorth).degrees(),
                            (fit->terms.tiltEast - truth.tiltEast).degrees()));
    }
    std::printf(
        "%4.2f° %2d points: north %5.3f° median, below 0.15° %5.1f %%, 0.05° %5.1f %%; arc, worst %5.3f° median, below "
        "0.15° %5.1f %%, 0.05° %5.1f %%; sky rms below 0.15° %5.1f %%; azimuth offset %5.3f° median, below 0.15° "
        "%5.1f %%, 0.05° %5.1f %%, within 2σ %5.1f %%; tilt below 0.1° %5.1f %%\n",
        noise, count, north.percentile(50.0), north.below(0.15), north.below(0.05), onArc.percentile(50.0),
        onArc.below(0.15), onArc.below(0.05), overSky.below(0.15), offset.percentile(50.0), offset.below(0.15),
        offset.below(0.05), inSigmas.below(2.0), tilt.below(0.1));
}

}  // namespace

int main(int argc, char** argv)
{
    const int runs = argc > 1 ? std::atoi(argv[1]) : kRuns;
    const unsigned long seed = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : kSeed;
    if (runs <= 0) {
        std::fprintf(stderr, "sun_statistics [RUNS [SEED]]\n");
        return 2;
    }
    for (const auto sides : {fakes::Sides::One, fakes::Sides::Both}) {
        std::printf("%s:\n", sides == fakes::Sides::One ? "From one side" : "Every third point over the top");
        for (const double noise : {0.01, 0.02, 0.03}) {
            for (const int count : {1, 2, 3, 4, 6, 12}) {
                measure(noise, count, sides, runs, seed);
            }
        }
    }
    return 0;
}
