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
// the azimuth of the axis. Out come north, the curve of the deviation, and what of it is to be believed. Pure;
// METHOD.md tells what a swing cannot see.
namespace boresight::calibration {

enum class Turning
{
    Clockwise,
    CounterClockwise
};

struct SwingSample
{
    Angle axisAzimuth;  // at the time the reading is about: the sensor's latency is dealt with
    AngularRate axisRate;
    Turning turning = Turning::Clockwise;  // the way it turns, or came to this heading
    orientation::SensorHeading heading;    // as sent, less the declination that the firmware adds
    std::optional<int> magnetometerCalibration;
    double motorCurrent = 0.0;           // A, the larger of the two motors'
    std::optional<Angle> axisElevation;  // for the curve, which holds there
};

// The sensor's firmware averages for a second: faster, a reading is smeared over more of the curve than it is good for.
inline constexpr AngularRate kFastestSwing = AngularRate::fromDegrees(6.0);

struct SwingLimits
{
    int calibration = 2;        // a sample below is not used; below 3 it counts a quarter
    double motorCurrent = 5.0;  // A. A sample above is not used. sensor.swing_current_a sets it
    // A sample above is not used. The limit is above the fastest swing by the scatter of a rate that is measured in
    // part of a second. A limit at the rate of the swing threw away every second reading.
    AngularRate rate = kFastestSwing * 1.25;
    Seconds latencySigma{0.1};                           // of what axisAzimuth was reckoned with
    Angle alignment = Angle::fromDegrees(0.5);           // sigma: of the box on the boom, and of the declination
    Angle leastConstant = Angle::fromDegrees(1.0);       // sigma of the constant where no soft iron is seen
    Angle unseenHarmonic = Angle::fromDegrees(2.0);      // sigma for a second harmonic that could not be fitted
    Angle unreliable = Angle::fromDegrees(3.0);          // a sector whose middle residual is beyond
    Angle hopelessRms = Angle::fromDegrees(5.0);         // of a single reading about the curve
    Angle hopelessAmplitude = Angle::fromDegrees(35.0);  // of the first harmonic
    double hopelessPart = 0.25;                          // of the samples far off, of the circle unreliable
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
    std::size_t sample = 0;  // its place in what was given
    Angle heading;           // true, as far as the swing tells
    Angle error;             // of the sensor: reading - heading, as a clockwise sensor
    Angle residual;          // what the curve leaves of it
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
    int sectors = 0;       // of 12, with samples that could be used
    Angle largestGap;      // without such samples
    bool isEven = true;    // no filled sector has less than a third of the mean
    bool bothWays = true;  // each direction has a quarter of the samples at least
};

struct CompassSwing
{
    Estimate north;     // azimuth from where the headings count = azimuth of the axis + north; 0…360°
    Angle statistical;  // the part of its sigma that comes from the readings,
    Angle systematic;   // and the part that no swing can see
    DeviationCurve curve;
    Harmonics harmonics = Harmonics::FirstAndSecond;
    Angle coefficientSigma;              // the largest of a1, b1, a2, b2
    std::optional<Estimate> hysteresis;  // heading read turning clockwise less the one read turning back
    SwingCoverage coverage;
    std::vector<SwingResidual> samples;
    std::vector<QString> hints;     // sentences; the result is usable all the same
    std::vector<QString> hopeless;  // reasons not to use a compass here; empty: usable

    [[nodiscard]] bool isUsable() const { return hopeless.empty(); }
};

// Refused with the reason, for the operator, where not even an offset can be had.
[[nodiscard]] Result<CompassSwing> fitCompassSwing(std::span<const SwingSample> samples,
                                                   const SwingLimits& limits = {});

}  // namespace boresight::calibration
