// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/offset_run.h"

#include "core/base/text.h"
#include "core/cross_check/sensor_curve.h"

#include <algorithm>

namespace boresight {

void OffsetRun::take(const orientation::Orientation& value, const AxesThen& about, const profile::Profile& profile,
                     Angle declination)
{
    const profile::SensorSettings& settings = profile.sensor;
    calibration::SensorReading reading{
        .axisAzimuth = about.place.azimuth, .axisRate = about.rates.azimuth, .motorCurrent = about.current};
    // Without a swing there is no curve to remove before the fit. Only the mounting of the sensor is corrected.
    reading.heading = wasSwung(settings)
                          ? value.heading
                          : orientation::SensorHeading::folded(curveOf(settings, declination).corrected(value.heading));
    reading.axisElevation = about.place.elevation;
    reading.azimuth = about.place.azimuth + profile.pointing.azimuthOffset;
    if (value.calibration) {
        reading.systemCalibration = value.calibration->system;
        reading.magnetometerCalibration = value.calibration->magnetometer;
    }
    m_readings.push_back(reading);
}

double OffsetRun::part(SteadyTime now) const
{
    return std::min(passed(now) / kDuration, 1.0);
}

Seconds OffsetRun::left(SteadyTime now) const
{
    return std::max(kDuration - passed(now), Seconds(0.0));
}

QString OffsetRun::text() const
{
    return Text::tr("readings: %1").arg(m_readings.size());
}

Result<calibration::SensorOffset> OffsetRun::outcome(const profile::SensorSettings& settings, Angle declination) const
{
    const auto curve = wasSwung(settings) ? std::optional(curveOf(settings, declination))
                                          : std::optional<calibration::DeviationCurve>();
    const calibration::SensorOffsetLimits limits{.motorCurrent = settings.stillCurrent};
    return calibration::sensorOffset(m_readings, limits, curve);
}

}  // namespace boresight
