// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"
#include "core/profile/sensor_settings.h"

// The sensor's mounting and the deviation of its compass: as a profile keeps them, as a calibration records them, and
// as the one curve that leads from what the sensor sends to a true heading. Pure.
namespace boresight {

[[nodiscard]] calibration::SensorMounting mountingOf(const profile::SensorSettings& settings);
void setMounting(profile::SensorSettings& settings, const calibration::SensorMounting& mounting);

// From the heading as sent. `declination`: what counts, whoever applies it.
[[nodiscard]] calibration::DeviationCurve curveOf(const profile::SensorSettings& settings, Angle declination);

// After north was found to be elsewhere: what was azimuth ψ is really ψ + correction.
[[nodiscard]] calibration::SensorMounting withNorthMoved(calibration::SensorMounting mounting, Angle correction);

}  // namespace boresight
