// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/sensor_offset.h"

#include "core/base/text.h"
#include "core/calibration/circular.h"
#include "core/calibration/fit_words.h"
#include "core/calibration/robust_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace boresight::calibration {
namespace {

constexpr double kSensorOffsetNoiseFloor = Angle::fromDegrees(0.1).radians();
constexpr double kFewestIndependent = 3.0;
constexpr Angle kStandsStill = Angle::fromDegrees(0.3);  // largest difference of the axis angles of a still mount

using Calibration = std::optional<int> SensorReading::*;

// Empty if no reading reports it.
std::optional<int> worst(std::span<const SensorReading> readings, Calibration which)
{
    std::optional<int> least;
    for (const SensorReading& reading : readings) {
        if (const std::optional<int> value = reading.*which) {
            least = std::min(least.value_or(*value), *value);
        }
    }
    return least;
}

}  // namespace

Result<> isCalibrated(std::optional<int> magnetometer, std::optional<int> system, int needed)
{
    if (magnetometer.value_or(needed) < needed) {
        return failure(ErrorCode::Refused, Text::tr("Magnetometer calibration is %1 of 3, but %2 is needed. Move the "
                                                    "sensor in figures of eight, away from iron.")
                                               .arg(*magnetometer)
                                               .arg(needed));
    }
    if (system.value_or(needed) < needed) {
        return failure(ErrorCode::Refused, Text::tr("System calibration of the sensor is %1 of 3, but %2 is needed. "
                                                    "Its heading is not referred to magnetic north yet.")
                                               .arg(*system)
                                               .arg(needed));
    }
    return {};
}

namespace {

// A hanging chip sends the same value for ever. If it reports its calibration, the level is then 0.
Result<> checkAlive(std::span<const SensorReading> readings)
{
    const bool same = std::all_of(readings.begin(), readings.end(),
                                  [&](const auto& reading) { return reading.heading == readings.front().heading; });
    if (same && !worst(readings, &SensorReading::magnetometerCalibration)) {
        return failure(ErrorCode::Refused,
                       Text::tr("The sensor repeats one value to the last digit. Switch it off and on."));
    }
    return {};
}

Result<> checkMount(std::span<const SensorReading> readings, const SensorOffsetLimits& limits)
{
    const auto pulls = std::find_if(readings.begin(), readings.end(), [&](const auto& reading) {
        return !(reading.motorCurrent <= limits.motorCurrent);
    });
    if (pulls != readings.end()) {
        return failure(ErrorCode::Refused, Text::tr("Motor current %1 A disturbs the compass (limit %2 A, "
                                                    "sensor.still_current_a). Wait a moment and try again.")
                                               .arg(pulls->motorCurrent, 0, 'f', 1)
                                               .arg(limits.motorCurrent, 0, 'f', 1));
    }
    const auto byAzimuth = [](const auto& a, const auto& b) { return a.axisAzimuth < b.axisAzimuth; };
    const auto [low, high] = std::minmax_element(readings.begin(), readings.end(), byAzimuth);
    const bool turns = std::any_of(readings.begin(), readings.end(),
                                   [&](const auto& reading) { return !(abs(reading.axisRate) <= limits.rate); });
    if (turns || high->axisAzimuth - low->axisAzimuth > kStandsStill) {
        return failure(ErrorCode::Refused, Text::tr("The mount is moving. It must stand still."));
    }
    return {};
}

Result<> check(std::span<const SensorReading> readings, const SensorOffsetLimits& limits)
{
    const bool finite = std::all_of(readings.begin(), readings.end(),
                                    [](const auto& reading) { return reading.axisAzimuth.isFinite(); });
    if (!finite) {
        return failure(ErrorCode::InvalidInput, Text::tr("The position of the mount is unknown."));
    }
    if (readings.empty() || readings.size() < limits.fewest) {
        return failure(ErrorCode::Refused,
                       Text::tr("There are %1 readings, but %2 are needed.").arg(readings.size()).arg(limits.fewest));
    }
    return isCalibrated(worst(readings, &SensorReading::magnetometerCalibration),
                        worst(readings, &SensorReading::systemCalibration), limits.calibration)
        .and_then([&] { return checkAlive(readings); })
        .and_then([&] { return checkMount(readings, limits); });
}

std::vector<Angle> offsetsOf(std::span<const SensorReading> readings, const DeviationCurve& curve)
{
    std::vector<Angle> offsets;
    for (const SensorReading& reading : readings) {
        offsets.push_back(curve.corrected(reading.heading) - reading.axisAzimuth);
    }
    return offsets;
}

// With a curve, the error is the curve's scatter, the sigma of its constant, and more at other elevations. The constant
// already includes alignment and declination. In an unreliable sector the curve is of no use.
Angle systematic(const SensorOffsetLimits& limits, const std::optional<DeviationCurve>& curve, bool isReliable,
                 const std::optional<Angle>& elevation)
{
    if (!curve || !isReliable) {
        return hypot(limits.unknownDeviation, limits.alignment);
    }
    const Angle away = elevation ? curve->sigmaAt(*elevation) : Angle{};
    return hypot(hypot(curve->scatter, curve->constantSigma.value_or(limits.curveConstant)), away);
}

}  // namespace

Result<SensorOffset> sensorOffset(std::span<const SensorReading> readings, const SensorOffsetLimits& limits,
                                  const std::optional<DeviationCurve>& curve, AzimuthSense sense)
{
    if (const Result<> good = check(readings, limits); !good) {
        return tl::unexpected(good.error());
    }
    const std::vector<Angle> offsets = offsetsOf(readings, curve.value_or(DeviationCurve{.sense = sense}));
    const Angle middle = circularMean(offsets).direction;
    RobustProblem problem(1);
    for (const Angle offset : offsets) {
        problem.add(std::array{1.0}, (offset - middle).wrapped180().radians());
    }
    const auto fit = fitRobustly(problem, kSensorOffsetNoiseFloor);
    if (!fit) {
        return failure(ErrorCode::Refused,
                       Text::tr("%1 readings are not enough, or they disagree. Take more.").arg(readings.size()));
    }
    if (fit->free < kFewestIndependent) {
        return failure(ErrorCode::Refused, Text::tr("The readings drift. Take readings for a longer time."));
    }
    const std::size_t rejected = readings.size() - fit->usedRows();
    const Angle scatter = Angle::fromRadians(fit->rms);
    if (scatter > limits.scatter ||
        static_cast<double>(rejected) > limits.outliers * static_cast<double>(offsets.size())) {
        return failure(ErrorCode::Refused,
                       Text::tr("The readings disagree. They scatter by %1, and %2 of %3 are far off.")
                           .arg(inWords(scatter))
                           .arg(rejected)
                           .arg(readings.size()));
    }
    const Angle offset = (middle + Angle::fromRadians(fit->solution[0])).wrapped360();
    const Angle statistical = Angle::fromRadians(std::sqrt(fit->variance(0)));
    const SensorReading& first = readings.front();
    const Angle heading = offset + first.axisAzimuth;
    const bool isReliable =
        !curve || (curve->isReliable(heading) && curve->isReliable(first.azimuth.value_or(heading)));
    const Angle common = systematic(limits, curve, isReliable, first.axisElevation);
    return SensorOffset{.offset = {offset, hypot(statistical, common)},
                        .statistical = statistical,
                        .scatter = scatter,
                        .used = fit->usedRows(),
                        .rejected = rejected,
                        .calibrationKnown = first.magnetometerCalibration.has_value(),
                        .isReliableHere = isReliable};
}

}  // namespace boresight::calibration
