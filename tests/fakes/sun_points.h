// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/pointing_solver.h"

#include <random>
#include <vector>

// Points taken at the Sun on one day by somebody who centres it with a given noise, on a mount with hidden terms. For
// the statistics of the pointing fit: the Sun's place is reckoned from declination and hour angle, which is all that
// matters there (core/ephemeris knows the real one). Degrees throughout.
namespace boresight::fakes {

struct SunDay
{
    double latitude = 0.0;
    double declination = 0.0;

    [[nodiscard]] SkyPointing at(double hourAngle) const;
    // Hour angles between which the Sun is above 10°; empty if it is for less than four hours.
    [[nodiscard]] std::vector<double> hours() const;
};

// Between the polar circles, any date.
[[nodiscard]] SunDay randomDay(std::mt19937_64& random);

// North 37.4°, tilt 0.6° to anywhere, collimation 0.3° to either side, a zero of elevation within 1°.
[[nodiscard]] pointing::PointingTerms randomHidden(std::mt19937_64& random);

enum class Sides
{
    One,
    Both  // of three points the middle one over the top, of six the second and the fifth
};

// Spread over the day, each anywhere in the middle of its part of it; none above 80°, where nobody centres well.
[[nodiscard]] std::vector<calibration::CalibrationPoint> sunPoints(const pointing::PointingTerms& hidden,
                                                                   const SunDay& day, int count, double noise,
                                                                   std::mt19937_64& random, Sides sides = Sides::One);

// How far the beam is off along the Sun's way of that day, at worst.
[[nodiscard]] double worstOnArc(const pointing::PointingTerms& hidden, const pointing::PointingTerms& fitted,
                                const SunDay& day);

// The rms of the same over the sky from 10° to 70° of elevation.
[[nodiscard]] double rmsOverSky(const pointing::PointingTerms& hidden, const pointing::PointingTerms& fitted);

// How well north is known: how far the azimuth of a level beam is off, at worst, all round.
[[nodiscard]] double northError(const pointing::PointingTerms& hidden, const pointing::PointingTerms& fitted);

}  // namespace boresight::fakes
