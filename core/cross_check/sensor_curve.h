// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"
#include "core/orientation/correction.h"
#include "core/profile/sensor_settings.h"
#include "core/units/sky.h"

#include <optional>

// The mounting of the sensor and the deviation of its compass, in three forms: as a profile stores them, as a
// calibration records them, and as one curve from the sent heading to a true heading. Pure.
namespace boresight {

[[nodiscard]] calibration::SensorMounting mountingOf(const profile::SensorSettings& settings);
void setMounting(profile::SensorSettings& settings, const calibration::SensorMounting& mounting);

// Whether a reading has the same meaning with both settings. Settings that only judge readings (how long without a
// value, how large a difference, how much current) make no difference.
[[nodiscard]] bool readAlike(profile::SensorSettings one, const profile::SensorSettings& other);

// Whether a swing has measured the deviation of the compass.
[[nodiscard]] bool wasSwung(const profile::SensorSettings& settings);

// The curve for the heading as sent. `declination`: the one that applies, whether the sensor or Boresight adds it.
[[nodiscard]] calibration::DeviationCurve curveOf(const profile::SensorSettings& settings, Angle declination);

// Converts the values of the sensor to true directions.
struct SensorToSky
{
    SensorToSky() = default;
    SensorToSky(const profile::SensorSettings& settings, const geomagnetism::Declination& declination);

    orientation::Correction correction;
    std::optional<calibration::DeviationCurve> deviation;  // only after a swing; includes mounting and declination

    [[nodiscard]] SkyPointing directionOf(const orientation::Orientation& value) const;
};

// The sigma of an azimuth that the curve gave: the error that all readings have in common. Empty: unknown.
[[nodiscard]] std::optional<Angle> azimuthSigma(const calibration::DeviationCurve& curve, const SkyPointing& direction);

// After a correction of north: azimuth ψ becomes ψ + correction, and is known to `sigma`.
[[nodiscard]] calibration::SensorMounting withNorthMoved(calibration::SensorMounting mounting, Angle correction,
                                                         Angle sigma);

}  // namespace boresight
