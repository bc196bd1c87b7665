// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/cross_scan.h"

#include "core/base/text.h"
#include "core/calibration/fit_words.h"
#include "core/calibration/robust_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace boresight::calibration {
namespace {

constexpr std::size_t kFewest = 7;
constexpr double kHalfPower = 4.0 * std::numbers::ln2;  // exp(-this × (offset / width)²): one half at half a width
constexpr double kCrossScanNoiseFloor = 0.02;           // of the power: 0.04 dB, finer than receivers report
constexpr double kBeamError = 0.2;      // of the peak: the sides of a beam differ from a Gaussian in proportion to it
constexpr double kNearZenith = 0.02;    // cosine of elevation: nearer to the zenith azimuth is meaningless
constexpr double kWorstSigma = 0.25;    // of the width: a less certain peak is rejected
constexpr double kLeastRise = 0.2;      // dB, by which the power must change along the line
constexpr double kLeastEvidence = 5.0;  // noise alone reaches this on a few of a hundred lines
constexpr double kNarrowest = 1.4;      // steps: a peak of a single reading is rejected
constexpr double kWidest = 3.0;         // of the line
constexpr int kRounds = 30;
constexpr double kStill = 1e-7;  // of the width

double linear(double decibels)
{
    return std::pow(10.0, decibels / 10.0);
}

double inDecibels(double power)
{
    return 10.0 * std::log10(power);
}

bool byOffset(const ScanReading& a, const ScanReading& b)
{
    return a.offset < b.offset;
}

// The readings along the line, each replaced by the median of itself and its two neighbours, so that one spike or gap
// is not taken for the peak or its end. At the ends of the line: the lower of two.
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

Result<> check(std::span<const ScanReading> readings)
{
    const bool finite = std::all_of(readings.begin(), readings.end(), [](const ScanReading& one) {
        return one.offset.isFinite() && std::isfinite(one.decibels);
    });
    if (!finite) {
        return failure(ErrorCode::InvalidInput, Text::tr("A reading is not a number."));
    }
    if (readings.size() < kFewest) {
        return failure(ErrorCode::Refused,
                       Text::tr("%1 readings are not enough. A peak needs %2.").arg(readings.size()).arg(kFewest));
    }
    return {};
}

// The readings of a line, sorted by offset. Here offsets are in units of half the line, from its middle. Powers are in
// units of the highest power.
struct Line
{
    std::vector<ScanReading> readings;
    Angle middle;
    Angle half;
    double unit = 0.0;             // dB
    std::vector<double> places;    // -1…1
    std::vector<double> powers;    // as read
    std::vector<double> smoothed;  // without spikes

    [[nodiscard]] double step() const { return 2.0 / static_cast<double>(places.size() - 1); }
    // The noise of a reading is proportional to its power.
    [[nodiscard]] double weight(std::size_t i) const { return std::pow(smoothed[i] + kBeamError, -2.0); }
};

Line lineOf(std::span<const ScanReading> readings)
{
    Line line;
    line.readings.assign(readings.begin(), readings.end());
    std::sort(line.readings.begin(), line.readings.end(), byOffset);
    line.middle = (line.readings.front().offset + line.readings.back().offset) / 2.0;
    line.half = (line.readings.back().offset - line.readings.front().offset) / 2.0;
    line.smoothed = smoothed(line.readings);
    line.unit = *std::max_element(line.smoothed.begin(), line.smoothed.end());
    for (double& power : line.smoothed) {
        power = linear(power - line.unit);
    }
    for (const ScanReading& reading : line.readings) {
        line.places.push_back((reading.offset - line.middle) / line.half);
        line.powers.push_back(linear(reading.decibels - line.unit));
    }
    return line;
}

// In the units of its line.
struct Beam
{
    double background = 0.0;
    double rise = 0.0;
    double place = 0.0;
    double width = 1.0;

    [[nodiscard]] double shape(double at) const
    {
        const double away = (at - place) / width;
        return std::exp(-kHalfPower * away * away);
    }
    [[nodiscard]] double power(double at) const { return background + rise * shape(at); }
};

// Fits background and rise for this position and width. Returns the sum of the squared residuals.
double fitPowers(Beam& beam, const Line& line)
{
    double g = 0.0;
    double gg = 0.0;
    double y = 0.0;
    double gy = 0.0;
    const auto n = static_cast<double>(line.places.size());
    for (std::size_t i = 0; i < line.places.size(); ++i) {
        const double shape = beam.shape(line.places[i]);
        g += shape;
        gg += shape * shape;
        y += line.smoothed[i];
        gy += shape * line.smoothed[i];
    }
    beam.rise = std::max(0.0, (n * gy - g * y) / (n * gg - g * g));
    beam.background = (y - beam.rise * g) / n;
    if (beam.background < 0.0) {
        beam.background = 0.0;
        beam.rise = gy / gg;
    }
    double square = 0.0;
    for (std::size_t i = 0; i < line.places.size(); ++i) {
        const double off = line.smoothed[i] - beam.power(line.places[i]);
        square += off * off;
    }
    return square;
}

// Tries every position and width, so that the start does not depend on a single reading near the peak.
Beam startingBeam(const Line& line)
{
    Beam best;
    double least = std::numeric_limits<double>::infinity();
    for (const double width : {0.25, 0.35, 0.5, 0.7, 1.0, 1.4, 2.0, 2.8}) {
        for (int step = -40; step <= 40; ++step) {
            Beam beam{.place = 0.05 * step, .width = width};
            if (width < kNarrowest * line.step()) {
                continue;
            }
            if (const double square = fitPowers(beam, line); square < least) {
                least = square;
                best = beam;
            }
        }
    }
    return best;
}

struct BeamFit
{
    Beam beam;
    RobustFit fit;  // of rise, position (in widths), logarithm of the width, and background if there is one
};

// The residuals, as a linear problem in rise, position, width and background.
RobustProblem linearised(const Beam& beam, const Line& line)
{
    const bool hasBackground = beam.background > 0.0;
    RobustProblem problem(hasBackground ? 4 : 3);
    for (std::size_t i = 0; i < line.places.size(); ++i) {
        const double away = (line.places[i] - beam.place) / beam.width;
        const double shape = beam.shape(line.places[i]);
        const double slope = 2.0 * kHalfPower * beam.rise * shape * away;
        const std::array row{shape, slope, slope * away, 1.0};
        problem.add(std::span(row).first(problem.unknowns()), line.powers[i] - beam.power(line.places[i]),
                    line.weight(i));
    }
    return problem;
}

// Gauss-Newton steps. They need a start near the solution.
std::optional<BeamFit> refined(Beam beam, const Line& line)
{
    for (int round = 0; round < kRounds; ++round) {
        auto fit = fitRobustly(linearised(beam, line), kCrossScanNoiseFloor);
        if (!fit) {
            return std::nullopt;
        }
        const double along = std::clamp(fit->solution[1], -0.3, 0.3);
        beam.rise += fit->solution[0];
        beam.place = std::clamp(beam.place + beam.width * along, -2.5, 2.5);
        beam.width = std::clamp(beam.width * std::exp(std::clamp(fit->solution[2], -0.3, 0.3)),
                                kNarrowest * line.step(), 2.0 * kWidest);
        if (fit->solution.size() > 3) {
            beam.background = std::max(0.0, beam.background + fit->solution[3]);
        }
        if (std::abs(along) < kStill || round == kRounds - 1) {
            return BeamFit{beam, std::move(*fit)};
        }
    }
    return std::nullopt;
}

// The line in elevation runs at the azimuth of the middle, so it may pass beside the source. At the point of the line
// that is nearest to the source, the line is higher than the source: tan(elevation) = tan(nearest) × cos(beside). The
// same formula applies over the top.
Angle seenFromBeside(Angle nearest, Angle beside)
{
    return Angle::fromRadians(
        std::atan2(std::sin(nearest.radians()) * std::cos(beside.radians()), std::cos(nearest.radians())));
}

// The scatter of the used readings about the curve, in dB of their power.
double scatterOf(const RobustFit& fit)
{
    const auto used = static_cast<double>(fit.usedRows());
    return inDecibels(1.0 + fit.rms * std::sqrt(used / (used - static_cast<double>(fit.solution.size()))));
}

// The F test of a peak against a constant power: what the beam explains for each of its unknowns, divided by the
// scatter of a reading. Counts only the readings that are used.
double evidence(const RobustFit& fit, const Line& line)
{
    double weights = 0.0;
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < line.powers.size(); ++i) {
        if (fit.used[i]) {
            weights += line.weight(i);
            sum += line.weight(i) * line.powers[i];
            squares += line.weight(i) * line.powers[i] * line.powers[i];
        }
    }
    const auto used = static_cast<double>(fit.usedRows());
    const auto unknowns = static_cast<double>(fit.solution.size());
    const double left = std::max(fit.rms * fit.rms, kCrossScanNoiseFloor * kCrossScanNoiseFloor / 12.0) * used;
    return (squares - sum * sum / weights - left) / (unknowns - 1.0) / (left / (used - unknowns));
}

Result<> checkPeak(const BeamFit& fitted, const Line& line)
{
    const Beam& beam = fitted.beam;
    if (!(beam.rise > 0.0) || !(evidence(fitted.fit, line) > kLeastEvidence)) {
        return failure(ErrorCode::Refused, Text::tr("The power has no peak along this line."));
    }
    if (std::abs(beam.place) >= 1.0) {
        // The position outside the line is only a guess, because the line has no peak. So scan again from its end.
        const Angle end = line.middle + line.half * (beam.place > 0.0 ? 1.0 : -1.0);
        return failure(
            ErrorCode::Refused,
            Text::tr("The peak is outside this line. Move the middle of the scan by at least %1 and scan again.")
                .arg((end > Angle{} ? QStringLiteral("+") : QString()) + inWords(end)));
    }
    if (beam.width <= kNarrowest * line.step()) {
        return failure(ErrorCode::Refused, Text::tr("The peak is narrower than the steps. Scan a smaller width."));
    }
    if (const double sigma = std::sqrt(fitted.fit.variance(1)); sigma > kWorstSigma) {
        return failure(ErrorCode::Refused,
                       Text::tr("The peak is uncertain by %1, because the readings scatter too much.")
                           .arg(inWords(line.half * beam.width * sigma, 2)));
    }
    return {};
}

ScanPeak peakOf(const BeamFit& fitted, Line line)
{
    const Beam& beam = fitted.beam;
    const Angle width = line.half * beam.width;
    return {.offset = {line.middle + line.half * beam.place, width * std::sqrt(fitted.fit.variance(1))},
            .decibels = line.unit + inDecibels(beam.background + beam.rise),
            .background = beam.background > 0.0 ? std::optional(line.unit + inDecibels(beam.background)) : std::nullopt,
            .halfPowerWidth = width,
            .scatter = scatterOf(fitted.fit),
            .used = fitted.fit.usedRows(),
            .readings = std::move(line.readings)};
}

}  // namespace

Result<ScanPeak> fitScan(std::span<const ScanReading> readings)
{
    if (const Result<> good = check(readings); !good) {
        return tl::unexpected(good.error());
    }
    Line line = lineOf(readings);
    const double change = -inDecibels(*std::min_element(line.smoothed.begin(), line.smoothed.end()));
    if (!(line.half > Angle{}) || change < kLeastRise) {
        return failure(ErrorCode::Refused,
                       Text::tr("The power changes by only %1 dB along this line.").arg(change, 0, 'f', 2));
    }
    const auto fitted = refined(startingBeam(line), line);
    if (!fitted) {
        return failure(ErrorCode::Refused, Text::tr("The power has no peak along this line."));
    }
    return checkPeak(*fitted, line).transform([&] { return peakOf(*fitted, std::move(line)); });
}

double decibelsAt(const ScanPeak& peak, Angle offset)
{
    const double away = (offset - peak.offset.value) / peak.halfPowerWidth;
    const double background = peak.background ? linear(*peak.background) : 0.0;
    return inDecibels(background + (linear(peak.decibels) - background) * std::exp(-kHalfPower * away * away));
}

Result<CrossScan> fitCrossScan(const AxisPosition& middle, std::span<const ScanReading> across,
                               std::span<const ScanReading> elevation, Angle elevationAt)
{
    const double shrink = std::cos(middle.elevation.radians());
    if (std::abs(shrink) < kNearZenith) {
        return failure(ErrorCode::Refused,
                       Text::tr("The beam is too near to the zenith. The azimuth has no meaning there."));
    }
    const auto acrossPeak = fitScan(across);
    if (!acrossPeak) {
        return failure(acrossPeak.error().code, Text::tr("across: %1").arg(acrossPeak.error().text));
    }
    const auto elevationPeak = fitScan(elevation);
    if (!elevationPeak) {
        return failure(elevationPeak.error().code, Text::tr("in elevation: %1").arg(elevationPeak.error().text));
    }
    const Angle beside = acrossPeak->offset.value / shrink;
    return CrossScan{.across = *acrossPeak,
                     .elevation = *elevationPeak,
                     .peak = {.azimuth = middle.azimuth + beside,
                              .elevation = seenFromBeside(middle.elevation + elevationPeak->offset.value,
                                                          beside - elevationAt / shrink)},
                     .sigma = std::max(acrossPeak->offset.sigma, elevationPeak->offset.sigma)};
}

}  // namespace boresight::calibration
