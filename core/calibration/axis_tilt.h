// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/calibration/estimate.h"

#include <cstddef>
#include <span>
#include <vector>

// How far the azimuth axis is from plumb, and the zero of elevation, from the elevations that the sensor's
// accelerometer tells while the mount turns with its boom held at one elevation. An error of the accelerometer is the
// same all round the circle, so it spoils the zero and not the tilt. Pure.
namespace boresight::calibration {

struct LevelSample
{
    Angle axisAzimuth;
    Angle axisElevation;
    Angle elevation;  // as the sensor says
};

struct LevelLimits
{
    Angle lowest = Angle::fromDegrees(10.0);        // of the boom: near 0° the sensor cannot tell up from down
    Angle highest = Angle::fromDegrees(80.0);       // of the boom: above, azimuth says little about direction
    Angle roll = Angle::fromDegrees(3.0);           // sigma of the box about the boom; it turns the tilt a little
    Angle zeroAlignment = Angle::fromDegrees(1.0);  // sigma of the box along the boom, and of the accelerometer's zero
};

struct AxisTilt
{
    Estimate north;  // the axis leans to the north, and to the east, as in the pointing model
    Estimate east;
    Angle size;
    Angle sizeSigma;
    Angle direction;           // 0…360°: where it leans to; means nothing while size is within its sigma
    Estimate elevationOffset;  // true elevation = elevation of the axis + this
    Angle scatter;             // rms
    std::vector<Angle> residuals;
    std::vector<std::size_t> rejected;
};

// `north`: true azimuth = azimuth of the axis + north. Refused with the reason, for the operator.
[[nodiscard]] Result<AxisTilt> fitAxisTilt(std::span<const LevelSample> samples, const Estimate& north,
                                           const LevelLimits& limits = {});

}  // namespace boresight::calibration
