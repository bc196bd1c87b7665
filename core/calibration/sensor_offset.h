// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/calibration/deviation_curve.h"
#include "core/calibration/estimate.h"
#include "core/orientation/orientation.h"

#include <cstddef>
#include <optional>
#include <span>

// North from a mount that stands still: the circular mean of the sensor's headings minus the azimuth of the axis. Pure.
// The scatter of the readings does not show the true error, because one heading does not reveal the deviation of the
// needle. So without a curve from a swing the sigma is some degrees, however long the readings last.
namespace boresight::calibration {

// One reading of the sensor, with the state of the mount at the time of the reading.
struct SensorReading
{
    orientation::SensorHeading heading;  // as sent, minus the declination that the firmware adds
    Angle axisAzimuth;
    AngularRate axisRate;
    double motorCurrent = 0.0;             // A, of the motor that draws more
    std::optional<int> systemCalibration;  // 0…3; MQTT does not report it
    std::optional<int> magnetometerCalibration;
    std::optional<Angle> axisElevation;  // a curve is most accurate at the elevation of its swing
    std::optional<Angle> azimuth;        // of the beam, by the north in force
};

struct SensorOffsetLimits
{
    std::size_t fewest = 10;
    int calibration = 2;                                // at least, of magnetometer and system
    double motorCurrent = 1.0;                          // A, at most; set by sensor.still_current_a
    AngularRate rate = AngularRate::fromDegrees(0.05);  // of the azimuth, at most
    Angle scatter = Angle::fromDegrees(3.0);            // rms, at most
    double outliers = 0.2;                              // of the readings, at most
    Angle unknownDeviation = Angle::fromDegrees(6.0);  // rms of ±8° once and ±3° twice round the circle, at one heading
    Angle alignment = Angle::fromDegrees(0.5);         // of the box on the boom, and of the declination
    Angle curveConstant = Angle::fromDegrees(1.6);  // if its sigma is unknown: usual for a swing (METHOD.md)
};

struct SensorOffset
{
    Estimate offset;    // azimuth from the north of the sensor = azimuth of the axis + offset; 0…360°
    Angle statistical;  // the part of the sigma that more readings reduce
    Angle scatter;      // rms of the readings
    std::size_t used = 0;
    std::size_t rejected = 0;
    bool calibrationKnown = true;
    // False: by the curve, iron disturbs the needle at the azimuth in force or at the azimuth by these readings. Iron
    // may have turned the latter out of its own sector.
    bool isReliableHere = true;
};

// Whether the levels that a sensor reports reach `needed`. A level that is not reported is ignored.
[[nodiscard]] Result<> isCalibrated(std::optional<int> magnetometer, std::optional<int> system, int needed);

// `curve`: from an earlier swing, if there was one; it includes the sense. Without a curve `sense` must be known,
// because the readings of a still mount do not show it. A refusal has a reason for the operator.
[[nodiscard]] Result<SensorOffset> sensorOffset(std::span<const SensorReading> readings,
                                                const SensorOffsetLimits& limits = {},
                                                const std::optional<DeviationCurve>& curve = std::nullopt,
                                                AzimuthSense sense = AzimuthSense::Clockwise);

}  // namespace boresight::calibration
