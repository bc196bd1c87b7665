// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/pointing_solver.h"

#include <random>
#include <vector>

// Points taken at the Sun on one day, centred with a given noise, on a mount with hidden terms. They serve the
// statistics of the pointing fit. The place of the Sun is computed from declination and hour angle, which is enough
// there (core/ephemeris computes the true place). All values in degrees.
namespace boresight::fakes {

struct SunDay
{
    double latitude = 0.0;
    double declination = 0.0;

    [[nodiscard]] SkyPointing at(double hourAngle) const;
    // The hour angles between which the Sun is above 10°. Empty if that is less than four hours.
    [[nodiscard]] std::vector<double> hours() const;
};

// A site between the polar circles, on any date.
[[nodiscard]] SunDay randomDay(std::mt19937_64& random);

// North 37.4°, tilt 0.6° in any direction, collimation 0.3° to either side, zero of elevation within 1°.
[[nodiscard]] pointing::PointingTerms randomHidden(std::mt19937_64& random);

enum class Sides
{
    One,
    Both  // of three points the middle one is taken over the top, of six the second and the fifth
};

// The points are spread over the day, each near the middle of its part of the day. None is above 80°, where centring is
// inaccurate.
[[nodiscard]] std::vector<calibration::CalibrationPoint> sunPoints(const pointing::PointingTerms& hidden,
                                                                   const SunDay& day, int count, double noise,
                                                                   std::mt19937_64& random, Sides sides = Sides::One);

// The largest error of the beam along the Sun's path of that day.
[[nodiscard]] double worstOnArc(const pointing::PointingTerms& hidden, const pointing::PointingTerms& fitted,
                                const SunDay& day);

// The rms error over the sky from 10° to 70° of elevation.
[[nodiscard]] double rmsOverSky(const pointing::PointingTerms& hidden, const pointing::PointingTerms& fitted);

// The error of north: the largest azimuth error of a level beam, all round.
[[nodiscard]] double northError(const pointing::PointingTerms& hidden, const pointing::PointingTerms& fitted);

}  // namespace boresight::fakes
