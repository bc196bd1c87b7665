// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/calibration/deviation_curve.h"
#include "core/calibration/estimate.h"
#include "core/orientation/orientation.h"

#include <QString>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

// Swinging the compass: while the mount turns through its azimuths, both ways, the sensor's heading is compared with
// the azimuth of the axis. The result is north, the curve of the deviation, and how reliable they are. Pure. METHOD.md
// describes what a swing cannot see.
namespace boresight::calibration {

enum class Turning
{
    Clockwise,
    CounterClockwise
};

struct SwingSample
{
    Angle axisAzimuth;  // at the time of the heading: the latency of the sensor is already removed
    AngularRate axisRate;
    Turning turning = Turning::Clockwise;  // the way in which the axis turns, or turned to reach this heading
    orientation::SensorHeading heading;    // as sent, minus the declination that the firmware adds
    std::optional<int> magnetometerCalibration;
    double motorCurrent = 0.0;           // A, of the motor that draws more
    std::optional<Angle> axisElevation;  // the curve is valid at this elevation
};

// The sensor's firmware averages over a second. At a higher rate, a reading covers too large a part of the curve.
inline constexpr AngularRate kFastestSwing = AngularRate::fromDegrees(6.0);

struct SwingLimits
{
    int calibration = 2;        // a sample below is not used; below 3 it counts a quarter
    double motorCurrent = 5.0;  // A. A sample above is not used. sensor.swing_current_a sets it
    // A sample above is not used. The measured rate scatters, because it is measured in part of a second. So the limit
    // is above the fastest swing. A limit at the rate of the swing would reject every second reading.
    AngularRate rate = kFastestSwing * 1.25;
    Seconds latencySigma{0.1};                           // sigma of the latency with which axisAzimuth was computed
    Angle alignment = Angle::fromDegrees(0.5);           // sigma of the box on the boom, and of the declination
    Angle leastConstant = Angle::fromDegrees(1.0);       // sigma of the constant if no soft iron is seen
    Angle unseenHarmonic = Angle::fromDegrees(2.0);      // sigma of a second harmonic that could not be fitted
    Angle unreliable = Angle::fromDegrees(3.0);          // a sector with a larger median residual is unreliable
    Angle hopelessRms = Angle::fromDegrees(5.0);         // of a single reading about the curve
    Angle hopelessAmplitude = Angle::fromDegrees(35.0);  // of the first harmonic
    Angle declination;  // for the headings in hints, which are true. All other results are relative to magnetic north
    double hopelessPart = 0.25;  // part of the samples that are outliers, or of the circle that is unreliable
};

enum class SampleFate
{
    Used,
    Outlier,       // beyond three sigma of the curve
    Uncalibrated,  // magnetometer below the limit
    MotorCurrent,
    TooFast
};
inline constexpr std::size_t kSampleFates = 5;

struct SwingResidual
{
    std::size_t sample = 0;  // index among the given samples
    Angle heading;           // true heading by this swing
    Angle error;             // error of the sensor: reading - heading, for a clockwise sensor
    Angle residual;          // the part of the error that the curve does not explain
    SampleFate fate = SampleFate::Used;
};

enum class Harmonics
{
    None,  // too little of the circle was seen: an offset only
    First,
    FirstAndSecond
};

struct SwingCoverage
{
    int sectors = 0;       // number of the 12 sectors that have usable samples
    Angle largestGap;      // without usable samples
    bool isEven = true;    // every filled sector has at least a third of the mean
    bool bothWays = true;  // each direction has at least a quarter of the samples
};

struct CompassSwing
{
    Estimate north;     // azimuth from the north of the sensor = azimuth of the axis + north; 0…360°
    Angle statistical;  // the part of the sigma of north that comes from the readings
    Angle systematic;   // the part that no swing can see
    DeviationCurve curve;
    Harmonics harmonics = Harmonics::FirstAndSecond;
    Angle coefficientSigma;              // the largest of a1, b1, a2, b2
    std::optional<Estimate> hysteresis;  // heading read while turning clockwise minus heading read while turning back
    SwingCoverage coverage;
    std::vector<SwingResidual> samples;
    std::vector<QString> hints;     // sentences; the result is usable in spite of them
    std::vector<QString> hopeless;  // reasons not to use a compass here; empty: usable

    [[nodiscard]] bool isUsable() const { return hopeless.empty(); }
};

// Refused, with a reason for the operator, if the readings do not even give an offset.
[[nodiscard]] Result<CompassSwing> fitCompassSwing(std::span<const SwingSample> samples,
                                                   const SwingLimits& limits = {});

}  // namespace boresight::calibration
