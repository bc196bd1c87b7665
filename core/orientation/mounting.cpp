// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orientation/mounting.h"

#include "core/orientation/judge.h"

namespace boresight::orientation {

Orientation asMounted(Orientation value, ElevationSense sense, Angle declinationInSensor)
{
    if (sense == ElevationSense::Down && !isDeadMark(value, declinationInSensor)) {
        value.elevation = -value.elevation;
    }
    return value;
}

}  // namespace boresight::orientation
