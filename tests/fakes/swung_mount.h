// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/axis_tilt.h"
#include "core/calibration/compass_swing.h"
#include "core/pointing/pointing_model.h"

#include <random>
#include <vector>

// Mounts with a compass sensor, with random north, tilt and deviation, and the readings of the sensor during a swing.
// They serve the statistics of the fits, and share only types with them. All values in degrees.
namespace boresight::fakes {

// The cause of the deflection of the compass needle.
enum class Needle
{
    // Exactly a first harmonic up to 8° and a second up to 3°, with uniform amplitudes and random phases.
    Harmonics,
    // Iron that turns with the sensor: hard iron up to 8° of deflection, and a soft-iron matrix whose four elements are
    // Gaussian with 3 %. Its antisymmetric part turns all headings alike (1.2° rms), and the box is mounted 0.5° rms
    // askew. A swing can see neither of these.
    Iron
};

struct SwungMount
{
    pointing::PointingTerms terms;  // random north, random tilt up to 1°; terms that are 0 do not move the sensor
    calibration::AzimuthSense sense = calibration::AzimuthSense::Clockwise;
    Needle needle = Needle::Harmonics;
    double firstAmplitude = 0.0;
    double firstPhase = 0.0;
    double secondAmplitude = 0.0;
    double secondPhase = 0.0;
    double hardForward = 0.0;  // size as a part of the Earth's horizontal field
    double hardRight = 0.0;
    double softIron[2][2] = {{0.0, 0.0}, {0.0, 0.0}};
    double askew = 0.0;      // rotation of the box about the vertical
    double steelFrom = 0.0;  // azimuth of the axis where the steel begins, 30° wide
    double steelStep = 0.0;  // added to the heading there
    double noise = 0.5;      // rms of a reading
    double memory = 0.4;     // correlation of the noise with that of the reading before
    double outliers =
        0.005;             // part of the readings that point anywhere, as when quaternions are averaged across a flip
    double latency = 0.5;  // s; the fit assumes 0.5
    double roll = 0.0;     // rotation of the box about the boom
    double gravityBias = 0.0;  // m/s², of the accelerometer

    [[nodiscard]] double north() const { return terms.azimuthOffset.degrees(); }
    // The heading of the sensor at this position of the axes, without noise.
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
    double rate = 3.0;  // degrees per second, there and back
    double elevation = 30.0;
    bool back = true;
    double period = 1.03;  // s between two readings
};

[[nodiscard]] Swung swing(const SwungMount& mount, std::mt19937_64& random, const SwingPlan& plan = {});

}  // namespace boresight::fakes
