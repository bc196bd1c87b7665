// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orbit/mean_orbit.h"

#include "core/orbit/earth_gravity.h"

#include <cmath>
#include <numbers>

namespace boresight::orbit {

namespace {

double axisOf(double motion)
{
    return std::pow(kSurfaceMotion / motion, 2.0 / 3.0);
}

// Converts Kozai's mean motion. Both are in rad/min.
double brouwerMotion(double kozai, double cosInclination, double roundness)
{
    const double first = axisOf(kozai);
    const double oblateness =
        0.75 * kJ2 * (3.0 * cosInclination * cosInclination - 1.0) / (std::sqrt(roundness) * roundness);
    const double shift = oblateness / (first * first);
    const double axis = first * (1.0 - shift * shift - shift * (1.0 / 3.0 + 134.0 / 81.0 * shift * shift));
    return kozai / (1.0 + oblateness / (axis * axis));
}

}  // namespace

MeanOrbit meanOrbitOf(const ElementSet& elements)
{
    MeanOrbit orbit{.eccentricity = elements.eccentricity,
                    .inclination = elements.inclination.radians(),
                    .node = elements.ascendingNode.radians(),
                    .perigee = elements.perigee.radians(),
                    .anomaly = elements.meanAnomaly.radians(),
                    .bstar = elements.bstar,
                    .sinInclination = std::sin(elements.inclination.radians()),
                    .cosInclination = std::cos(elements.inclination.radians()),
                    .roundness = 1.0 - elements.eccentricity * elements.eccentricity};
    const double kozai = elements.revolutionsPerDay * 2.0 * std::numbers::pi / kMinutesPerDay;
    orbit.motion = brouwerMotion(kozai, orbit.cosInclination, orbit.roundness);
    orbit.axis = axisOf(orbit.motion);
    return orbit;
}

SecularRates secularRates(const MeanOrbit& orbit)
{
    const double inverse = 1.0 / (orbit.parameter() * orbit.parameter());
    const double byJ2 = 1.5 * kJ2 * inverse * orbit.motion;
    const double byJ2Squared = 0.5 * byJ2 * kJ2 * inverse;
    const double byJ4 = -0.46875 * kJ4 * inverse * inverse * orbit.motion;
    const double cosine = orbit.cosInclination;
    const double square = cosine * cosine;
    const double fourth = square * square;
    const double round = std::sqrt(orbit.roundness);
    SecularRates rates;
    rates.anomaly = orbit.motion + 0.5 * byJ2 * round * (3.0 * square - 1.0) +
                    0.0625 * byJ2Squared * round * (13.0 - 78.0 * square + 137.0 * fourth);
    rates.perigee = -0.5 * byJ2 * (1.0 - 5.0 * square) +
                    0.0625 * byJ2Squared * (7.0 - 114.0 * square + 395.0 * fourth) +
                    byJ4 * (3.0 - 36.0 * square + 49.0 * fourth);
    rates.nodeByJ2 = -byJ2 * cosine;
    rates.node =
        rates.nodeByJ2 + (0.5 * byJ2Squared * (4.0 - 19.0 * square) + 2.0 * byJ4 * (3.0 - 7.0 * square)) * cosine;
    return rates;
}

}  // namespace boresight::orbit
