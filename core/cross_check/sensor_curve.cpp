// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cross_check/sensor_curve.h"

#include "core/calibration/fit_words.h"

namespace boresight {
namespace {

using calibration::AzimuthSense;
using calibration::DeviationCurve;

// The curve for a heading without any declination.
DeviationCurve bareCurve(const profile::SensorSettings& settings)
{
    const profile::CompassDeviation& deviation = settings.deviation;
    DeviationCurve curve{.sense = settings.mounting.sense,
                         .constant = -settings.mounting.azimuthOffset,
                         .a1 = deviation.a1,
                         .b1 = deviation.b1,
                         .a2 = deviation.a2,
                         .b2 = deviation.b2};
    if (deviation.sigma > Angle{}) {
        curve.constantSigma = deviation.sigma;
        curve.elevation = deviation.elevation;
    }
    for (const auto& [from, to] : deviation.unreliable) {
        curve.unreliable.push_back({.from = from, .to = to});
    }
    return curve;
}

}  // namespace

calibration::SensorMounting mountingOf(const profile::SensorSettings& settings)
{
    calibration::SensorMounting mounting{.sense = settings.mounting.sense,
                                         .azimuthOffset = settings.mounting.azimuthOffset,
                                         .elevationOffset = settings.mounting.elevationOffset};
    if (wasSwung(settings)) {
        mounting.curve = bareCurve(settings);
    }
    return mounting;
}

void setMounting(profile::SensorSettings& settings, const calibration::SensorMounting& mounting)
{
    settings.mounting.sense = mounting.sense;
    settings.mounting.azimuthOffset = mounting.azimuthOffset;
    settings.mounting.elevationOffset = mounting.elevationOffset;
    const DeviationCurve curve = mounting.curve.value_or(DeviationCurve{});
    settings.deviation = {.a1 = curve.a1,
                          .b1 = curve.b1,
                          .a2 = curve.a2,
                          .b2 = curve.b2,
                          .sigma = curve.constantSigma.value_or(Angle{}),
                          .elevation = curve.elevation.value_or(Angle{})};
    for (const calibration::UnreliableSector& sector : curve.unreliable) {
        settings.deviation.unreliable.push_back({.from = sector.from, .to = sector.to});
    }
}

bool readAlike(profile::SensorSettings one, const profile::SensorSettings& other)
{
    one.lost = other.lost;
    one.disagreement = other.disagreement;
    one.disagreementTime = other.disagreementTime;
    one.stillCurrent = other.stillCurrent;
    one.swingCurrent = other.swingCurrent;
    return one == other;
}

bool wasSwung(const profile::SensorSettings& settings)
{
    return settings.deviation != profile::CompassDeviation{};
}

DeviationCurve curveOf(const profile::SensorSettings& settings, Angle declination)
{
    DeviationCurve curve = bareCurve(settings);
    const Angle added = settings.declinationInSensor;  // by the sensor, in either sense
    curve.constant += (curve.sense == AzimuthSense::Clockwise ? added : -added) - declination;
    return curve;
}

SensorToSky::SensorToSky(const profile::SensorSettings& settings, const geomagnetism::Declination& declination)
    : correction(settings.mounting, declination)
{
    if (wasSwung(settings)) {
        deviation = curveOf(settings, correction.declination());
    }
}

SkyPointing SensorToSky::directionOf(const orientation::Orientation& value) const
{
    SkyPointing direction = correction.direction(value);
    if (deviation) {
        direction.azimuth = deviation->corrected(value.heading);
    }
    return direction;
}

std::optional<Angle> azimuthSigma(const DeviationCurve& curve, const SkyPointing& direction)
{
    if (!curve.constantSigma) {
        return std::nullopt;
    }
    return calibration::hypot(*curve.constantSigma, curve.sigmaAt(direction.elevation));
}

calibration::SensorMounting withNorthMoved(calibration::SensorMounting mounting, Angle correction, Angle sigma)
{
    mounting.azimuthOffset = (mounting.azimuthOffset + correction).wrapped180();
    if (mounting.curve) {
        mounting.curve = mounting.curve->withNorthMoved(correction);
        mounting.curve->constant = -mounting.azimuthOffset;
        mounting.curve->constantSigma = sigma;
    }
    return mounting;
}

}  // namespace boresight
