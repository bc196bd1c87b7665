// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geomagnetism/declination.h"
#include "core/orientation/mounting.h"
#include "core/orientation/orientation.h"
#include "core/units/sky.h"

// Converts the sensor's heading to a true direction, by its mounting and the declination that applies. The deviation by
// iron near the sensor is corrected elsewhere (core/calibration). Pure.
//
// The firmware adds its declination to the heading, which may count counter-clockwise. So this declination is
// subtracted, the sense is corrected, and exactly one declination is added, as geomagnetism::Declination decides.
namespace boresight::orientation {

class Correction
{
public:
    Correction() = default;
    // If the declination is unknown, the declination of the sensor stays in the heading.
    Correction(const Mounting& mounting, const geomagnetism::Declination& declination);

    [[nodiscard]] Angle trueHeading(SensorHeading heading) const;
    [[nodiscard]] Angle elevation(Angle raw) const { return raw + m_mounting.elevationOffset; }
    [[nodiscard]] SkyPointing direction(const Orientation& value) const
    {
        return {.azimuth = trueHeading(value.heading), .elevation = elevation(value.elevation)};
    }
    // The declination that the true heading contains.
    [[nodiscard]] Angle declination() const { return m_inSensor + m_correction; }

private:
    Mounting m_mounting;
    Angle m_inSensor = geomagnetism::kDeclinationInFirmware;
    Angle m_correction;  // replaces the declination of the sensor
};

}  // namespace boresight::orientation
