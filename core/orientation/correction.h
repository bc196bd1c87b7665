// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geomagnetism/declination.h"
#include "core/orientation/mounting.h"
#include "core/orientation/orientation.h"
#include "core/units/sky.h"

// From what the sensor says to a true direction: how it is mounted and whose declination counts. What iron near it does
// is another matter (core/calibration). Pure.
//
// The firmware adds its declination to a heading that may count against the compass; so it is taken off, the rest is
// turned the right way round, and exactly one declination is added, as geomagnetism::Declination decides.
namespace boresight::orientation {

class Correction
{
public:
    Correction() = default;
    // A declination that is not known is not applied: the sensor's stays.
    Correction(const Mounting& mounting, const geomagnetism::Declination& declination);

    [[nodiscard]] Angle trueHeading(SensorHeading heading) const;
    [[nodiscard]] Angle elevation(Angle raw) const { return raw + m_mounting.elevationOffset; }
    [[nodiscard]] SkyPointing direction(const Orientation& value) const
    {
        return {.azimuth = trueHeading(value.heading), .elevation = elevation(value.elevation)};
    }
    // What is in the true heading in the end.
    [[nodiscard]] Angle declination() const { return m_inSensor + m_correction; }

private:
    Mounting m_mounting;
    Angle m_inSensor = geomagnetism::kDeclinationInFirmware;
    Angle m_correction;  // in place of the sensor's
};

}  // namespace boresight::orientation
