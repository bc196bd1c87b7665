// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/axis_tilt.h"
#include "core/calibration/compass_swing.h"
#include "core/pointing/pointing_model.h"

#include <random>
#include <vector>

// Mounts with a compass sensor whose north, tilt and deviation are drawn at random, and what the sensor says while they
// are swung. For the statistics of the fits; nothing is shared with them but the types. Degrees throughout.
namespace boresight::fakes {

// What bends the needle.
enum class Needle
{
    // Exactly a first harmonic up to 8° and a second up to 3°, amplitudes uniform, phases random.
    Harmonics,
    // Iron that turns with the sensor: hard iron up to 8° of deflection, and a soft-iron matrix whose four elements are
    // Gaussian of 3 %. Its antisymmetric part moves all headings alike (1.2° rms), and the box is 0.5° rms askew: a
    // swing sees neither.
    Iron
};

struct SwungMount
{
    pointing::PointingTerms
        terms;  // north anywhere, tilt up to 1° to anywhere; what else is 0 does not move the sensor
    calibration::AzimuthSense sense = calibration::AzimuthSense::Clockwise;
    Needle needle = Needle::Harmonics;
    double firstAmplitude = 0.0;
    double firstPhase = 0.0;
    double secondAmplitude = 0.0;
    double secondPhase = 0.0;
    double hardForward = 0.0;  // of the Earth's horizontal field
    double hardRight = 0.0;
    double softIron[2][2] = {{0.0, 0.0}, {0.0, 0.0}};
    double askew = 0.0;      // of the box about the vertical
    double steelFrom = 0.0;  // azimuth of the axis, for 30° from there
    double steelStep = 0.0;  // added there
    double noise = 0.5;      // rms of a reading
    double memory = 0.4;     // of the noise: its correlation with the reading before
    double outliers =
        0.005;             // part of the readings that point anywhere, as when quaternions are averaged across a flip
    double latency = 0.5;  // s; reckoned with as 0.5
    double roll = 0.0;     // of the box about the boom
    double gravityBias = 0.0;  // m/s², of the accelerometer

    [[nodiscard]] double north() const { return terms.azimuthOffset.degrees(); }
    // Of the sensor, without noise, at this place of the axes.
    [[nodiscard]] double heading(double axisAzimuth, double axisElevation) const;
};

[[nodiscard]] SwungMount randomMount(std::mt19937_64& random, Needle needle);

struct Swung
{
    std::vector<calibration::SwingSample> samples;
    std::vector<calibration::LevelSample> levels;
};

struct SwingPlan
{
    double from = 0.0;  // azimuth of the axis
    double to = 360.0;
    double rate = 3.0;  // per second, there and back
    double elevation = 30.0;
    bool back = true;
    double period = 1.03;  // s between two readings
};

[[nodiscard]] Swung swing(const SwungMount& mount, std::mt19937_64& random, const SwingPlan& plan = {});

}  // namespace boresight::fakes
