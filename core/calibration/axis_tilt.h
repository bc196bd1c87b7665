// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/calibration/estimate.h"

#include <cstddef>
#include <span>
#include <vector>

// How far the azimuth axis leans from the vertical, and the zero of elevation. Both come from the elevations that the
// sensor's accelerometer reports while the mount turns with its boom at one elevation. An error of the accelerometer is
// the same all round the circle, so it affects the zero but not the tilt. Pure.
namespace boresight::calibration {

struct LevelSample
{
    Angle axisAzimuth;
    Angle axisElevation;
    Angle elevation;  // as the sensor reports it
};

struct LevelLimits
{
    Angle lowest = Angle::fromDegrees(10.0);   // of the boom: near 0° the sensor cannot distinguish up from down
    Angle highest = Angle::fromDegrees(80.0);  // of the boom: above this, azimuth says little about direction
    Angle roll = Angle::fromDegrees(3.0);  // sigma of the roll of the box about the boom, which turns the tilt a little
    Angle zeroAlignment = Angle::fromDegrees(1.0);  // sigma of the box along the boom, and of its zero
};

struct AxisTilt
{
    Estimate north;  // lean of the axis to the north and to the east, as in the pointing model
    Estimate east;
    Angle size;
    Angle sizeSigma;
    Angle direction;           // 0…360°: where the axis leans to; undefined while size is within its sigma
    Estimate elevationOffset;  // true elevation = elevation of the axis + this
    Angle scatter;             // rms
    std::vector<Angle> residuals;
    std::vector<std::size_t> rejected;
};

// `north`: true azimuth = azimuth of the axis + north. A refusal has a reason for the operator.
[[nodiscard]] Result<AxisTilt> fitAxisTilt(std::span<const LevelSample> samples, const Estimate& north,
                                           const LevelLimits& limits = {});

}  // namespace boresight::calibration
