// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/sensor_curve.h"

namespace boresight {
namespace {

using calibration::AzimuthSense;
using calibration::DeviationCurve;

// About the heading without any declination.
DeviationCurve bareCurve(const profile::SensorSettings& settings)
{
    const auto& [a1, b1, a2, b2] = settings.deviation;
    return {.sense = settings.mounting.sense,
            .constant = -settings.mounting.azimuthOffset,
            .a1 = a1,
            .b1 = b1,
            .a2 = a2,
            .b2 = b2};
}

}  // namespace

calibration::SensorMounting mountingOf(const profile::SensorSettings& settings)
{
    calibration::SensorMounting mounting{.sense = settings.mounting.sense,
                                         .azimuthOffset = settings.mounting.azimuthOffset,
                                         .elevationOffset = settings.mounting.elevationOffset};
    if (settings.deviation != profile::CompassDeviation{}) {
        mounting.curve = bareCurve(settings);
    }
    return mounting;
}

void setMounting(profile::SensorSettings& settings, const calibration::SensorMounting& mounting)
{
    settings.mounting = {
        .sense = mounting.sense, .azimuthOffset = mounting.azimuthOffset, .elevationOffset = mounting.elevationOffset};
    const DeviationCurve curve = mounting.curve.value_or(DeviationCurve{});
    settings.deviation = {.a1 = curve.a1, .b1 = curve.b1, .a2 = curve.a2, .b2 = curve.b2};
}

DeviationCurve curveOf(const profile::SensorSettings& settings, Angle declination)
{
    DeviationCurve curve = bareCurve(settings);
    const Angle added = settings.declinationInSensor;  // by the sensor, whichever way it counts
    curve.constant += (curve.sense == AzimuthSense::Clockwise ? added : -added) - declination;
    return curve;
}

calibration::SensorMounting withNorthMoved(calibration::SensorMounting mounting, Angle correction)
{
    mounting.azimuthOffset = (mounting.azimuthOffset + correction).wrapped180();
    if (mounting.curve) {
        mounting.curve = mounting.curve->withNorthMoved(correction);
        mounting.curve->constant = -mounting.azimuthOffset;
    }
    return mounting;
}

}  // namespace boresight
