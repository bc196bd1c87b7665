// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/cross_scan.h"

#include "core/base/text.h"
#include "core/calibration/robust_fit.h"
#include "core/calibration/words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace boresight::calibration {
namespace {

constexpr std::size_t kFewest = 6;
constexpr double kNoiseFloor = 0.02;       // dB: finer than receivers tell
constexpr double kHalfPower = 3.0103;      // dB
constexpr double kLeastAbove = 1e-3;       // of the background's power, that a reading must be above it to count
constexpr double kNearZenith = 0.02;       // cosine of elevation: azimuth says nothing there
constexpr double kWorstSigma = 0.25;       // of the width: a peak less certain is none
constexpr double kLeastSlopeSigmas = 3.0;  // of the curvature, above its sigma

double linear(double decibels)
{
    return std::pow(10.0, decibels / 10.0);
}

// Without the receiver's own noise, if that was measured; what does not rise above it is left out.
std::vector<ScanReading> ofSource(std::span<const ScanReading> readings, const ScanLimits& limits)
{
    std::vector<ScanReading> result;
    for (const ScanReading& reading : readings) {
        if (!limits.background) {
            result.push_back(reading);
            continue;
        }
        const double noise = linear(*limits.background);
        const double source = linear(reading.decibels) - noise;
        if (source > kLeastAbove * noise) {
            result.push_back({reading.offset, 10.0 * std::log10(source)});
        }
    }
    return result;
}

bool byOffset(const ScanReading& a, const ScanReading& b)
{
    return a.offset < b.offset;
}

// Along the line, each the middle one of itself and its neighbours: one spike or gap is neither peak nor end of it. At
// the ends the lower of the two.
std::vector<double> smoothed(const std::vector<ScanReading>& ordered)
{
    std::vector<double> result;
    for (std::size_t i = 0; i < ordered.size(); ++i) {
        const double here = ordered[i].decibels;
        const double before = i > 0 ? ordered[i - 1].decibels : -std::numeric_limits<double>::infinity();
        const double after =
            i + 1 < ordered.size() ? ordered[i + 1].decibels : -std::numeric_limits<double>::infinity();
        result.push_back(std::max(std::min(before, after), std::min(here, std::max(before, after))));
    }
    return result;
}

// The readings about the best one, down to the given depth: side lobes are not part of the peak.
std::vector<ScanReading> aboutPeak(const std::vector<ScanReading>& ordered, const std::vector<double>& power,
                                   double depth)
{
    const auto best = std::max_element(power.begin(), power.end());
    const auto isBelow = [floor = *best - depth](double decibels) { return decibels < floor; };
    const auto last = std::find_if(best, power.end(), isBelow) - power.begin();
    const auto first = std::find_if(std::reverse_iterator(best), power.rend(), isBelow).base() - power.begin();
    return {ordered.begin() + first, ordered.begin() + last};
}

Result<> check(std::span<const ScanReading> readings)
{
    const bool finite = std::all_of(readings.begin(), readings.end(), [](const ScanReading& one) {
        return one.offset.isFinite() && std::isfinite(one.decibels);
    });
    if (!finite) {
        return failure(ErrorCode::InvalidInput, Text::tr("a reading is not a number"));
    }
    if (readings.size() < kFewest) {
        return failure(ErrorCode::Refused,
                       Text::tr("%1 readings show the source, and a peak needs %2").arg(readings.size()).arg(kFewest));
    }
    return {};
}

struct Parabola
{
    Angle middle;  // of the offsets, and half their range: the fit is in units of it
    Angle half;
    RobustFit fit;

    [[nodiscard]] double peak() const { return -fit.solution[1] / (2.0 * fit.solution[2]); }
    [[nodiscard]] bool bends() const { return fit.solution[2] < -kLeastSlopeSigmas * std::sqrt(fit.variance(2)); }
    // Of the peak: from the covariance of slope and curvature.
    [[nodiscard]] double sigma() const
    {
        const double bySlope = -1.0 / (2.0 * fit.solution[2]);
        const double byCurve = -peak() / fit.solution[2];
        const double both = fit.covariance[1 * 3 + 2];
        return std::sqrt(bySlope * bySlope * fit.variance(1) + byCurve * byCurve * fit.variance(2) +
                         2.0 * bySlope * byCurve * both);
    }
};

std::optional<Parabola> fitParabola(const std::vector<ScanReading>& readings)
{
    const Angle low = readings.front().offset;
    const Angle high = readings.back().offset;
    Parabola parabola{.middle = (low + high) / 2.0, .half = (high - low) / 2.0, .fit = {}};
    if (!(parabola.half > Angle{})) {
        return std::nullopt;
    }
    RobustProblem problem(3);
    for (const ScanReading& reading : readings) {
        const double x = (reading.offset - parabola.middle) / parabola.half;
        problem.add(std::array{1.0, x, x * x}, reading.decibels);
    }
    auto fit = fitRobustly(problem, kNoiseFloor);
    if (!fit) {
        return std::nullopt;
    }
    parabola.fit = std::move(*fit);
    return parabola;
}

Result<ScanPeak> peakOf(const Parabola& parabola)
{
    const double x = parabola.peak();
    if (!parabola.bends()) {
        return failure(ErrorCode::Refused, Text::tr("the power has no peak along this line"));
    }
    if (std::abs(x) >= 1.0) {
        // How far beyond its end is a guess of a line that has no peak: so scan again from there.
        const Angle end = parabola.middle + parabola.half * (x > 0.0 ? 1.0 : -1.0);
        return failure(ErrorCode::Refused,
                       Text::tr("the peak is not inside this line: move its middle by %1 or more and scan again")
                           .arg((end > Angle{} ? QStringLiteral("+") : QString()) + inWords(end)));
    }
    const double curve = parabola.fit.solution[2];
    return ScanPeak{.offset = {parabola.middle + parabola.half * x, parabola.half * parabola.sigma()},
                    .decibels = parabola.fit.solution[0] - curve * x * x,
                    .halfPowerWidth = parabola.half * (2.0 * std::sqrt(kHalfPower / -curve)),
                    .scatter = parabola.fit.rms,
                    .used = parabola.fit.usedRows()};
}

// The line in elevation runs at the azimuth of the middle. Where it comes nearest to a source that is so far beside it,
// it is higher than the source: tan(elevation) = tan(nearest) × cos(beside). Over the top the same holds.
Angle seenFromBeside(Angle nearest, Angle beside)
{
    return Angle::fromRadians(
        std::atan2(std::sin(nearest.radians()) * std::cos(beside.radians()), std::cos(nearest.radians())));
}

}  // namespace

Result<ScanPeak> fitScan(std::span<const ScanReading> readings, const ScanLimits& limits)
{
    std::vector<ScanReading> source = ofSource(readings, limits);
    if (const Result<> good = check(source); !good) {
        return tl::unexpected(good.error());
    }
    std::sort(source.begin(), source.end(), byOffset);
    const std::vector<double> power = smoothed(source);
    const auto [low, high] = std::minmax_element(power.begin(), power.end());
    if (*high - *low < limits.least) {
        return failure(ErrorCode::Refused,
                       Text::tr("the power changes by %1 dB only along this line").arg(*high - *low, 0, 'f', 2));
    }
    const std::vector<ScanReading> top = aboutPeak(source, power, limits.depth);
    const auto parabola = top.size() < kFewest ? std::nullopt : fitParabola(top);
    if (!parabola) {
        return failure(ErrorCode::Refused, Text::tr("%1 readings within %2 dB of the best are too few: scan in smaller "
                                                    "steps")
                                               .arg(top.size())
                                               .arg(limits.depth, 0, 'f', 0));
    }
    return peakOf(*parabola).and_then([](const ScanPeak& peak) -> Result<ScanPeak> {
        if (peak.offset.sigma > peak.halfPowerWidth * kWorstSigma) {
            return failure(ErrorCode::Refused, Text::tr("the peak is uncertain by %1: the readings scatter too much")
                                                   .arg(inWords(peak.offset.sigma, 2)));
        }
        return peak;
    });
}

Result<CrossScan> fitCrossScan(const AxisPosition& middle, std::span<const ScanReading> across,
                               std::span<const ScanReading> elevation, const ScanLimits& limits)
{
    const double shrink = std::cos(middle.elevation.radians());
    if (std::abs(shrink) < kNearZenith) {
        return failure(ErrorCode::Refused, Text::tr("too near to the zenith: azimuth says nothing there"));
    }
    const auto acrossPeak = fitScan(across, limits);
    if (!acrossPeak) {
        return failure(acrossPeak.error().code, Text::tr("across: %1").arg(toQString(acrossPeak.error().text)));
    }
    const auto elevationPeak = fitScan(elevation, limits);
    if (!elevationPeak) {
        return failure(elevationPeak.error().code,
                       Text::tr("in elevation: %1").arg(toQString(elevationPeak.error().text)));
    }
    const Angle beside = acrossPeak->offset.value / shrink;
    return CrossScan{.across = *acrossPeak,
                     .elevation = *elevationPeak,
                     .peak = {.azimuth = middle.azimuth + beside,
                              .elevation = seenFromBeside(middle.elevation + elevationPeak->offset.value, beside)},
                     .sigma = std::max(acrossPeak->offset.sigma, elevationPeak->offset.sigma)};
}

}  // namespace boresight::calibration
