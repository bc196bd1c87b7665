// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cross_check/sensor_comparison.h"

namespace boresight {
namespace {

// Below these levels the compass is not related to magnetic north, or may soon lose it.
constexpr int kFewestMagnetometer = 2;
constexpr int kFewestSystem = 1;
constexpr int kFewestAccelerometer = 1;

SensorCheckSettings checkSettings(const profile::SensorSettings& sensor)
{
    return {.threshold = sensor.disagreement,
            .time = sensor.disagreementTime,
            .latency = sensor.latency,
            .averaging = sensor.averaging};
}

}  // namespace

bool isTiedToNorth(const orientation::Calibration& calibration)
{
    return calibration.magnetometer >= kFewestMagnetometer && calibration.system >= kFewestSystem;
}

bool isLevel(const orientation::Orientation& value)
{
    return !value.calibration || value.calibration->accelerometer >= kFewestAccelerometer;
}

SensorComparison::SensorComparison(const profile::SensorSettings& settings) : m_check(checkSettings(settings)) {}

void SensorComparison::judgeBy(const profile::SensorSettings& settings)
{
    m_check.setSettings(checkSettings(settings));
}

void SensorComparison::convertBy(const SensorToSky& toSky)
{
    m_toSky = toSky;
    m_check.forget();
}

void SensorComparison::take(const orientation::Orientation& value)
{
    const bool tied = !value.calibration || isTiedToNorth(*value.calibration);
    m_check.take({.direction = directionOf(value),
                  .arrival = value.arrival,
                  .azimuthCounts = tied && isReliable(value),
                  .elevationCounts = isLevel(value)});
}

bool SensorComparison::isReliable(const orientation::Orientation& value) const
{
    const SensorCheck::Passed azimuths = measuredAt(value);
    return !m_toSky.deviation || m_toSky.deviation->isReliable(azimuths.least, azimuths.most);
}

SensorCheck::Passed SensorComparison::measuredAt(const orientation::Orientation& value) const
{
    const Angle azimuth = directionOf(value).azimuth;
    return m_check.azimuthsOf(value.arrival)
        .value_or(SensorCheck::Passed{.least = azimuth, .mean = azimuth, .most = azimuth});
}

}  // namespace boresight
