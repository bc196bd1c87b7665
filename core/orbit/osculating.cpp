// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orbit/osculating.h"

#include "core/orbit/earth_gravity.h"

#include <algorithm>
#include <cmath>

namespace boresight::orbit {

namespace {

constexpr double kKilometresPerSecond = kEarthRadius * kSurfaceMotion / 60.0;

// Kepler's equation in equinoctial form, F(E) = E - U + ayn cos E - axn sin E = 0, with E = eccentric anomaly +
// argument of latitude of the perigee. Halley's step converges cubically, so a nearly circular orbit needs one call of
// the library's sine and cosine.
Turn eccentricLongitude(double meanLongitude, double axn, double ayn)
{
    constexpr int kMostSteps = 10;
    constexpr double kLongestStep = 0.95;  // rad, as published
    constexpr double kLastStep = 1e-6;     // the next step would be below 1e-14
    Turn at = turnOf(meanLongitude);
    double ahead = 0.0;  // E minus the mean longitude
    for (int i = 0; i < kMostSteps; ++i) {
        const double slope = 1.0 - axn * at.cos - ayn * at.sin;
        const double newton = (axn * at.sin - ayn * at.cos - ahead) / slope;
        const double bend = 1.0 + 0.5 * newton * (axn * at.sin - ayn * at.cos) / slope;
        const double step = std::clamp(bend > 0.5 ? newton / bend : newton, -kLongestStep, kLongestStep);
        ahead += step;
        at = turnedBy(at, step);
        if (!(std::abs(step) > kLastStep)) {
            break;
        }
    }
    return at;
}

// Radius, speeds and argument of latitude on the ellipse, before the periodics of J2 are added.
struct Ellipse
{
    Ellipse(double axis, double axn, double ayn, const Turn& eccentric)
    {
        const double eCosE = axn * eccentric.cos + ayn * eccentric.sin;
        const double eSinE = axn * eccentric.sin - ayn * eccentric.cos;
        const double eSquare = axn * axn + ayn * ayn;
        parameter = axis * (1.0 - eSquare);
        round = std::sqrt(1.0 - eSquare);
        radius = axis * (1.0 - eCosE);
        radial = std::sqrt(axis) * eSinE / radius;
        across = std::sqrt(parameter) / radius;
        const double share = eSinE / (1.0 + round);
        const double scale = axis / radius;
        latitude = {scale * (eccentric.sin - ayn - axn * share), scale * (eccentric.cos - axn + ayn * share)};
    }

    double parameter;  // semi-latus rectum
    double round;      // √(1 - e²)
    double radius;
    double radial;  // Earth radii per 1/kSurfaceMotion minutes
    double across;
    Turn latitude;
};

// Unit vectors along the radius and across it in the orbital plane, which is turned by node and inclination.
struct Axes
{
    Axes(const Turn& latitude, const Turn& node, const Turn& inclination)
    {
        const double x = -node.sin * inclination.cos;
        const double y = node.cos * inclination.cos;
        outward = {x * latitude.sin + node.cos * latitude.cos, y * latitude.sin + node.sin * latitude.cos,
                   inclination.sin * latitude.sin};
        ahead = {x * latitude.cos - node.cos * latitude.sin, y * latitude.cos - node.sin * latitude.sin,
                 inclination.sin * latitude.cos};
    }

    Vector outward;
    Vector ahead;
};

OrbitResult withShortPeriodics(const Ellipse& ellipse, double motion, double node, const Tilt& tilt)
{
    const double sin2u = 2.0 * ellipse.latitude.cos * ellipse.latitude.sin;
    const double cos2u = 1.0 - 2.0 * ellipse.latitude.sin * ellipse.latitude.sin;
    const double first = 0.5 * kJ2 / ellipse.parameter;
    const double second = first / ellipse.parameter;
    const double radius =
        ellipse.radius * (1.0 - 1.5 * second * ellipse.round * tilt.radial) + 0.5 * first * tilt.sinSquare * cos2u;
    if (!(radius >= 1.0)) {
        return tl::unexpected(OrbitFault::Decayed);
    }
    const double speed = motion / kSurfaceMotion * first;
    const double radial = ellipse.radial - speed * tilt.sinSquare * sin2u;
    const double across = ellipse.across + speed * (tilt.sinSquare * cos2u + 1.5 * tilt.radial);
    const double sideways = 1.5 * second * tilt.inclination.cos;
    const Axes axes(turnedBy(ellipse.latitude, -0.25 * second * tilt.along * sin2u), turnOf(node + sideways * sin2u),
                    turnedBy(tilt.inclination, sideways * tilt.inclination.sin * cos2u));
    return OrbitState{
        .position = (radius * kEarthRadius) * axes.outward,
        .velocity = (radial * kKilometresPerSecond) * axes.outward + (across * kKilometresPerSecond) * axes.ahead};
}

}  // namespace

Tilt::Tilt(const Turn& of) : inclination(of)
{
    constexpr double kLeast = 1.5e-12;  // near 180° the term of J3 grows without limit
    const double square = of.cos * of.cos;
    radial = 3.0 * square - 1.0;
    sinSquare = 1.0 - square;
    along = 7.0 * square - 1.0;
    longPerigee = -0.5 * (kJ3 / kJ2) * of.sin;
    const double divisor = std::abs(1.0 + of.cos) > kLeast ? 1.0 + of.cos : kLeast;
    longLongitude = -0.25 * (kJ3 / kJ2) * of.sin * (3.0 + 5.0 * of.cos) / divisor;
}

OrbitResult osculatingState(const MomentElements& mean, const Tilt& tilt)
{
    const Turn perigee = turnOf(mean.perigee);
    const double inverse = 1.0 / (mean.axis * (1.0 - mean.eccentricity * mean.eccentricity));
    const double axn = mean.eccentricity * perigee.cos;
    const double ayn = mean.eccentricity * perigee.sin + inverse * tilt.longPerigee;
    if (!(axn * axn + ayn * ayn < 1.0)) {
        return tl::unexpected(OrbitFault::SemiLatusRectum);
    }
    const double longitude = mean.anomaly + mean.perigee + inverse * tilt.longLongitude * axn;
    const Ellipse ellipse(mean.axis, axn, ayn, eccentricLongitude(longitude, axn, ayn));
    const double motion = kSurfaceMotion / (mean.axis * std::sqrt(mean.axis));
    return withShortPeriodics(ellipse, motion, mean.node, tilt);
}

}  // namespace boresight::orbit
