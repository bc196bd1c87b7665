// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"
#include "core/orientation/correction.h"
#include "core/profile/sensor_settings.h"
#include "core/units/sky.h"

#include <optional>

// The sensor's mounting and the deviation of its compass: as a profile keeps them, as a calibration records them, and
// as the one curve that leads from what the sensor sends to a true heading. Pure.
namespace boresight {

[[nodiscard]] calibration::SensorMounting mountingOf(const profile::SensorSettings& settings);
void setMounting(profile::SensorSettings& settings, const calibration::SensorMounting& mounting);

// Whether a reading means the same with both. What only judges (how long without one, how far apart, how much current)
// changes none.
[[nodiscard]] bool readAlike(profile::SensorSettings one, const profile::SensorSettings& other);

// Whether a swing has found what iron does to its compass.
[[nodiscard]] bool wasSwung(const profile::SensorSettings& settings);

// From the heading as sent. `declination`: what counts, whoever applies it.
[[nodiscard]] calibration::DeviationCurve curveOf(const profile::SensorSettings& settings, Angle declination);

// How what the sensor sends becomes a true direction.
struct SensorToSky
{
    SensorToSky() = default;
    SensorToSky(const profile::SensorSettings& settings, const geomagnetism::Declination& declination);

    orientation::Correction correction;
    std::optional<calibration::DeviationCurve> deviation;  // if a swing found one: mounting and declination are in it

    [[nodiscard]] SkyPointing directionOf(const orientation::Orientation& value) const;
    // The swing found no steel that steers the compass there.
    [[nodiscard]] bool isReliable(const SkyPointing& direction) const;
};

// Of the azimuth of a true direction that the curve led to: what is the same in all readings. Empty: not known.
[[nodiscard]] std::optional<Angle> azimuthSigma(const calibration::DeviationCurve& curve, const SkyPointing& direction);

// After north was found to be elsewhere: what was azimuth ψ is really ψ + correction, and known to `sigma`.
[[nodiscard]] calibration::SensorMounting withNorthMoved(calibration::SensorMounting mounting, Angle correction,
                                                         Angle sigma);

}  // namespace boresight
