// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/swing_samples.h"

#include "core/calibration/circular.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

namespace boresight::calibration {
namespace {

constexpr int kCoverageSectors = 12;
constexpr double kFullTurn = 360.0;

// Three sectors determine the mean and a first harmonic, five also a second one. Additional sectors distinguish noise
// from curve.
constexpr int kSectorsForFirst = 5;
constexpr int kSectorsForSecond = 8;
constexpr Angle kGapForFirst = Angle::fromDegrees(150.0);
constexpr Angle kGapForSecond = Angle::fromDegrees(75.0);

constexpr double kLeastOfMean = 1.0 / 3.0;
constexpr double kLeastOneWay = 0.25;
constexpr double kClearlyBetter = 1.5;

constexpr int kPaintedSectors = 36;
constexpr std::size_t kFewestInSector = 3;
constexpr int kGoodInARow = 2;  // beyond the edge of iron

int sectorOf(Angle azimuth, int sectors)
{
    return std::min(static_cast<int>(azimuth.wrapped360().degrees() / kFullTurn * sectors), sectors - 1);
}

Angle largestGap(std::span<const SwingSample> usable)
{
    std::vector<Angle> azimuths;
    for (const SwingSample& sample : usable) {
        azimuths.push_back(sample.axisAzimuth.wrapped360());
    }
    std::sort(azimuths.begin(), azimuths.end());
    Angle largest = Angle::fromDegrees(kFullTurn) - (azimuths.back() - azimuths.front());
    for (std::size_t i = 1; i < azimuths.size(); ++i) {
        largest = std::max(largest, azimuths[i] - azimuths[i - 1]);
    }
    return largest;
}

// The spread about the mean direction: the standard deviation of a wrapped Gaussian.
double spread(std::span<const SwingSample> usable, AzimuthSense sense)
{
    std::vector<Angle> offsets;
    for (const SwingSample& sample : usable) {
        offsets.push_back(headingOffset(sample, sense));
    }
    const double length = std::clamp(circularMean(offsets).length, 1e-9, 1.0 - 1e-9);
    return std::sqrt(-2.0 * std::log(length));
}

bool isHeard(const SwingResidual& sample)
{
    return sample.fate == SampleFate::Used || sample.fate == SampleFate::Outlier;
}

// How far iron may reach beyond an edge: to the first of the readings in a row that it does not deflect. One deflected
// reading after them is noise. `beyond`: the distance of a heading from the edge, away from the sector.
Angle reachOfIron(std::span<const SwingResidual> samples, Angle limit, const std::function<Angle(Angle)>& beyond)
{
    const Angle step = Angle::fromDegrees(kFullTurn / kPaintedSectors);
    std::vector<std::pair<Angle, bool>> outwards;  // whether the reading is deflected
    for (const SwingResidual& sample : samples) {
        const Angle apart = beyond(sample.heading);
        if (isHeard(sample) && apart <= step) {
            outwards.emplace_back(apart, abs(sample.residual) > limit);
        }
    }
    std::ranges::sort(outwards);
    const auto end = std::ranges::search_n(outwards, kGoodInARow, false, {}, &std::pair<Angle, bool>::second);
    return end.empty() ? step : end.front().first;
}

// Iron ends anywhere, and not where a step ends.
UnreliableSector widened(const UnreliableSector& sector, std::span<const SwingResidual> samples, Angle limit)
{
    const Angle before =
        reachOfIron(samples, limit, [&](Angle heading) { return (sector.from - heading).wrapped360(); });
    const Angle after = reachOfIron(samples, limit, [&](Angle heading) { return (heading - sector.to).wrapped360(); });
    const bool isCircle = sector.width() + before + after >= Angle::fromDegrees(kFullTurn);
    const Angle to = isCircle ? sector.from - before : sector.to + after;
    return {.from = (sector.from - before).wrapped360(), .to = to.wrapped360(), .residual = sector.residual};
}

// `next` begins where `first` ends, or before.
UnreliableSector joined(const UnreliableSector& first, const UnreliableSector& next)
{
    const bool isLarger = abs(next.residual) > abs(first.residual);
    return {.from = first.from,
            .to = next.contains(first.from) ? first.from : next.to,  // the whole circle
            .residual = isLarger ? next.residual : first.residual};
}

Angle medianOf(std::vector<Angle> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

SampleFate fateOf(const SwingSample& sample, const SwingLimits& limits)
{
    if (sample.magnetometerCalibration.value_or(limits.calibration) < limits.calibration) {
        return SampleFate::Uncalibrated;
    }
    if (!(sample.motorCurrent <= limits.motorCurrent)) {
        return SampleFate::MotorCurrent;
    }
    return abs(sample.axisRate) <= limits.rate ? SampleFate::Used : SampleFate::TooFast;
}

SwingCoverage coverageOf(std::span<const SwingSample> usable)
{
    if (usable.empty()) {
        return {.sectors = 0, .largestGap = Angle::fromDegrees(kFullTurn), .isEven = false, .bothWays = false};
    }
    std::array<int, kCoverageSectors> counts{};
    int clockwise = 0;
    for (const SwingSample& sample : usable) {
        ++counts[static_cast<std::size_t>(sectorOf(sample.axisAzimuth, kCoverageSectors))];
        clockwise += sample.turning == Turning::Clockwise ? 1 : 0;
    }
    const auto all = static_cast<double>(usable.size());
    const auto filled = std::count_if(counts.begin(), counts.end(), [](int count) { return count > 0; });
    const double fewest = kLeastOfMean * all / static_cast<double>(filled);
    const double part = clockwise / all;
    return {
        .sectors = static_cast<int>(filled),
        .largestGap = largestGap(usable),
        .isEven = std::none_of(counts.begin(), counts.end(), [&](int count) { return count > 0 && count < fewest; }),
        .bothWays = part >= kLeastOneWay && part <= 1.0 - kLeastOneWay};
}

Harmonics harmonicsFor(const SwingCoverage& coverage)
{
    if (coverage.sectors >= kSectorsForSecond && coverage.largestGap <= kGapForSecond) {
        return Harmonics::FirstAndSecond;
    }
    const bool first = coverage.sectors >= kSectorsForFirst && coverage.largestGap <= kGapForFirst;
    return first ? Harmonics::First : Harmonics::None;
}

std::optional<AzimuthSense> senseOf(std::span<const SwingSample> usable)
{
    const double with = spread(usable, AzimuthSense::Clockwise);
    const double against = spread(usable, AzimuthSense::CounterClockwise);
    if (std::max(with, against) < kClearlyBetter * std::min(with, against)) {
        return std::nullopt;
    }
    return with < against ? AzimuthSense::Clockwise : AzimuthSense::CounterClockwise;
}

Angle headingOffset(const SwingSample& sample, AzimuthSense sense)
{
    return (sense == AzimuthSense::Clockwise ? sample.heading.angle() : -sample.heading.angle()) - sample.axisAzimuth;
}

std::vector<UnreliableSector> unreliableSectors(std::span<const SwingResidual> samples, Angle limit)
{
    std::array<std::vector<Angle>, kPaintedSectors> residuals;
    for (const SwingResidual& sample : samples) {
        if (isHeard(sample)) {
            residuals[static_cast<std::size_t>(sectorOf(sample.heading, kPaintedSectors))].push_back(sample.residual);
        }
    }
    const Angle width = Angle::fromDegrees(kFullTurn / kPaintedSectors);
    std::vector<UnreliableSector> sectors;
    for (int i = 0; i < kPaintedSectors; ++i) {
        const auto& here = residuals[static_cast<std::size_t>(i)];
        const Angle middle = here.size() < kFewestInSector ? Angle{} : medianOf(here);
        if (abs(middle) <= limit) {
            continue;
        }
        if (sectors.empty() || sectors.back().to < width * i) {
            sectors.push_back({.from = width * i, .to = width * i, .residual = middle});
        }
        UnreliableSector& last = sectors.back();
        last.to = width * (i + 1);
        last.residual = abs(middle) > abs(last.residual) ? middle : last.residual;
    }
    const bool throughNorth =
        sectors.size() > 1 && sectors.front().from == Angle{} && sectors.back().to >= width * kPaintedSectors;
    if (throughNorth) {
        sectors.back() = joined(sectors.back(), sectors.front());
        sectors.erase(sectors.begin());
    }
    return sectors;
}

std::vector<UnreliableSector> widened(std::span<const UnreliableSector> sectors, std::span<const SwingResidual> samples,
                                      Angle limit)
{
    std::vector<UnreliableSector> all;
    for (const UnreliableSector& sector : sectors) {
        const UnreliableSector next = widened(sector, samples, limit);
        if (!all.empty() && all.back().contains(next.from)) {
            all.back() = joined(all.back(), next);
        } else {
            all.push_back(next);
        }
    }
    if (all.size() > 1 && all.back().contains(all.front().from)) {
        all.back() = joined(all.back(), all.front());
        all.erase(all.begin());
    }
    return all;
}

}  // namespace boresight::calibration
