// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/calibration/deviation_curve.h"
#include "core/calibration/estimate.h"
#include "core/orientation/orientation.h"

#include <cstddef>
#include <optional>
#include <span>

// North from a mount that stands still: what the sensor says, averaged over a circle, less where the azimuth axis is.
// Pure. The scatter of the readings says little about how true this is: at one heading the deviation of the needle is
// not seen. Without a curve from a swing the sigma is therefore some degrees, however long one listens.
namespace boresight::calibration {

// One reading of the sensor, with the state of the mount at the time it is about.
struct SensorReading
{
    orientation::SensorHeading heading;  // as sent, less the declination that the firmware adds
    Angle axisAzimuth;
    AngularRate axisRate;
    double motorCurrent = 0.0;             // A, the larger of the two motors'
    std::optional<int> systemCalibration;  // 0…3; MQTT does not tell
    std::optional<int> magnetometerCalibration;
    std::optional<Angle> axisElevation;  // a curve holds best at the elevation at which it was swung
};

struct SensorOffsetLimits
{
    std::size_t fewest = 10;
    int calibration = 2;                                // of magnetometer and system, at least
    double motorCurrent = 1.0;                          // A, at most; as sensor.still_current_a says
    AngularRate rate = AngularRate::fromDegrees(0.05);  // of the azimuth, at most
    Angle scatter = Angle::fromDegrees(3.0);            // rms, at most
    double outliers = 0.2;                              // of the readings, at most
    Angle unknownDeviation = Angle::fromDegrees(6.0);  // rms of ±8° once and ±3° twice round the circle, at one heading
    Angle alignment = Angle::fromDegrees(0.5);         // of the box on the boom, and of the declination
    Angle curveConstant = Angle::fromDegrees(1.6);  // of a curve that does not tell: what swings have (METHOD.md)
};

struct SensorOffset
{
    Estimate offset;    // azimuth from where the headings count = azimuth of the axis + offset; 0…360°
    Angle statistical;  // the part of sigma that more readings make smaller
    Angle scatter;      // rms of the readings
    std::size_t used = 0;
    std::size_t rejected = 0;
    bool calibrationKnown = true;
    bool isReliableHere = true;  // false: the curve says that steel steers the needle at this heading
};

// Whether the levels that a sensor reports reach `needed`. A level that it does not report is no obstacle.
[[nodiscard]] Result<> isCalibrated(std::optional<int> magnetometer, std::optional<int> system, int needed);

// `curve`: from an earlier swing, if there was one; it tells the sense. Without one it has to be known: nothing in the
// readings of a still mount shows it. Refused with the reason, for the operator.
[[nodiscard]] Result<SensorOffset> sensorOffset(std::span<const SensorReading> readings,
                                                const SensorOffsetLimits& limits = {},
                                                const std::optional<DeviationCurve>& curve = std::nullopt,
                                                AzimuthSense sense = AzimuthSense::Clockwise);

}  // namespace boresight::calibration
