// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/calibration_change.h"

#include "core/cross_check/sensor_curve.h"

namespace boresight {

void CalibrationChange::applyTo(profile::Profile& profile) const
{
    profile.pointing = terms;
    if (sensor) {
        setMounting(profile.sensor, *sensor);
    }
}

}  // namespace boresight
