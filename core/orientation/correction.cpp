// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orientation/correction.h"

namespace boresight::orientation {

Angle Correction::declination() const
{
    switch (m_settings.declination) {
        case Declination::OfSensor:
            return m_settings.ofSensor;
        case Declination::OfSite:
            return m_settings.ofSite;
        case Declination::None:
            break;
    }
    return {};
}

Angle Correction::trueHeading(SensorHeading heading) const
{
    const Angle magnetic = heading.angle() - m_settings.ofSensor;
    const Angle clockwise = m_settings.sense == Sense::Clockwise ? magnetic : -magnetic;
    return (clockwise + m_settings.azimuthOffset + declination()).wrapped360();
}

}  // namespace boresight::orientation
