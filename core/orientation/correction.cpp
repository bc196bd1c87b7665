// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orientation/correction.h"

namespace boresight::orientation {

Correction::Correction(const Mounting& mounting, const geomagnetism::Declination& declination)
    : m_mounting(mounting),
      m_inSensor(declination.inSensor),
      m_correction(geomagnetism::declinationCorrection(declination).value_or(Angle{}))
{}

Angle Correction::trueHeading(SensorHeading heading) const
{
    const Angle magnetic = heading.angle() - m_inSensor;
    const Angle clockwise = m_mounting.sense == Sense::Clockwise ? magnetic : -magnetic;
    return (clockwise + m_mounting.azimuthOffset + declination()).wrapped360();
}

}  // namespace boresight::orientation
