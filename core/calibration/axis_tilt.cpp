// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/axis_tilt.h"

#include "core/base/text.h"
#include "core/calibration/fit_words.h"
#include "core/calibration/robust_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace boresight::calibration {
namespace {

constexpr double kNoiseFloor = Angle::fromDegrees(0.06).radians();  // the sensor's resolution: 0.01 m/s² of gravity
constexpr double kLeastArc = 120.0;                                 // degrees of azimuth
constexpr std::size_t kFew = 6;  // three unknowns, and enough readings to estimate their noise

Angle arcOf(std::span<const LevelSample> samples)
{
    const auto byAzimuth = [](const auto& a, const auto& b) { return a.axisAzimuth < b.axisAzimuth; };
    const auto [low, high] = std::minmax_element(samples.begin(), samples.end(), byAzimuth);
    return high->axisAzimuth - low->axisAzimuth;
}

Result<> check(std::span<const LevelSample> samples, const LevelLimits& limits)
{
    const bool finite = std::all_of(samples.begin(), samples.end(), [](const LevelSample& one) {
        return one.axisAzimuth.isFinite() && one.axisElevation.isFinite() && one.elevation.isFinite();
    });
    if (!finite) {
        return failure(ErrorCode::InvalidInput, Text::tr("A reading is not a number."));
    }
    const bool inside = std::all_of(samples.begin(), samples.end(), [&](const LevelSample& one) {
        return one.axisElevation >= limits.lowest && one.axisElevation <= limits.highest;
    });
    if (!inside) {
        return failure(ErrorCode::Refused, Text::tr("The tilt is measured with the boom between %1 and %2.")
                                               .arg(inWords(limits.lowest, 0), inWords(limits.highest, 0)));
    }
    if (samples.empty() || arcOf(samples).degrees() < kLeastArc) {
        return failure(ErrorCode::Refused, Text::tr("The tilt needs readings over at least %1 of azimuth.")
                                               .arg(inWords(Angle::fromDegrees(kLeastArc), 0)));
    }
    return {};
}

RobustProblem problemOf(std::span<const LevelSample> samples, Angle north)
{
    RobustProblem problem(3);
    for (const LevelSample& sample : samples) {
        const double azimuth = (sample.axisAzimuth + north).radians();
        problem.add(std::array{1.0, -std::cos(azimuth), -std::sin(azimuth)},
                    (sample.elevation - sample.axisElevation).radians());
    }
    return problem;
}

// Let the sensor's axis be at the elevation e in the plane of the boom. For a box that is rolled about the boom by r,
// cos(reading) = cos(e) - (tilt along the boom) sin(e) + r × (tilt across it). To first order, the reading is too small
// by r × (tilt across) / sin(e). So the roll turns the measured tilt by a part of its size. An error of north turns it,
// too.
Angle turned(std::span<const LevelSample> samples, const Estimate& north, const LevelLimits& limits, Angle across)
{
    Angle sum;
    for (const LevelSample& sample : samples) {
        sum += sample.axisElevation;
    }
    const Angle elevation = sum / static_cast<double>(samples.size());
    return hypot(across * (limits.roll.radians() / std::sin(elevation.radians())), across * north.sigma.radians());
}

AxisTilt takeOver(const RobustFit& fit)
{
    const auto angle = [](double radians) { return Angle::fromRadians(radians); };
    AxisTilt tilt;
    tilt.elevationOffset = {angle(fit.solution[0]), angle(std::sqrt(fit.variance(0)))};
    tilt.north = {angle(fit.solution[1]), angle(std::sqrt(fit.variance(1)))};
    tilt.east = {angle(fit.solution[2]), angle(std::sqrt(fit.variance(2)))};
    tilt.size = hypot(tilt.north.value, tilt.east.value);
    tilt.direction = angle(std::atan2(fit.solution[2], fit.solution[1])).wrapped360();
    tilt.sizeSigma = std::max(tilt.north.sigma, tilt.east.sigma);
    tilt.scatter = angle(fit.rms);
    for (std::size_t i = 0; i < fit.residuals.size(); ++i) {
        tilt.residuals.push_back(angle(fit.residuals[i]));
        if (!fit.used[i]) {
            tilt.rejected.push_back(i);
        }
    }
    return tilt;
}

}  // namespace

Result<AxisTilt> fitAxisTilt(std::span<const LevelSample> samples, const Estimate& north, const LevelLimits& limits)
{
    if (const Result<> good = check(samples, limits); !good) {
        return tl::unexpected(good.error());
    }
    const auto fit = fitRobustly(problemOf(samples, north.value), kNoiseFloor);
    if (!fit) {
        return failure(ErrorCode::Refused,
                       samples.size() < kFew
                           ? Text::tr("%1 readings are not enough for the tilt.").arg(samples.size())
                           : Text::tr("The readings do not determine the tilt. Take readings at more azimuths."));
    }
    AxisTilt tilt = takeOver(*fit);
    tilt.north.sigma = hypot(tilt.north.sigma, turned(samples, north, limits, tilt.east.value));
    tilt.east.sigma = hypot(tilt.east.sigma, turned(samples, north, limits, tilt.north.value));
    tilt.elevationOffset.sigma = hypot(tilt.elevationOffset.sigma, limits.zeroAlignment);
    return tilt;
}

}  // namespace boresight::calibration
