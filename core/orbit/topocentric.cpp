// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orbit/topocentric.h"

#include "core/orbit/sidereal_time.h"

#include <cmath>

namespace boresight::orbit {

namespace {

constexpr double kRotation = 7.29211514670698e-5;  // of the Earth, rad/s
constexpr double kLightSpeed = 299792.458;         // km/s
// WGS-84, which sites use.
constexpr double kEquatorRadius = 6378.137;  // km
constexpr double kFlattening = 1.0 / 298.257223563;
constexpr double kSquaredEccentricity = kFlattening * (2.0 - kFlattening);

// The length of the normal from the Earth's axis to the ellipsoid, km.
double normalLength(double sinLatitude)
{
    return kEquatorRadius / std::sqrt(1.0 - kSquaredEccentricity * sinLatitude * sinLatitude);
}

}  // namespace

GroundState groundState(const OrbitState& state, const JulianDate& utc)
{
    const double angle = siderealTime(utc);
    const double s = std::sin(angle);
    const double c = std::cos(angle);
    const auto turned = [&](const Vector& v) { return Vector{c * v.x + s * v.y, c * v.y - s * v.x, v.z}; };
    const Vector position = turned(state.position);
    const Vector carried{-kRotation * position.y, kRotation * position.x, 0.0};
    return {.position = position, .velocity = turned(state.velocity) - carried};
}

// Bowring's formula, followed by one iteration of it. The error is below 1e-9° from the ground to beyond the Moon.
// (Survey Review 23, 1976.)
Site subSatellitePoint(const Vector& ground)
{
    const double polarRadius = kEquatorRadius * (1.0 - kFlattening);
    const double across = std::hypot(ground.x, ground.y);
    double parametric = std::atan2(kEquatorRadius * ground.z, polarRadius * across);
    double latitude = 0.0;
    for (int i = 0; i < 2; ++i) {
        const double s = std::sin(parametric);
        const double c = std::cos(parametric);
        const double secondSquare = kSquaredEccentricity / (1.0 - kSquaredEccentricity);
        latitude = std::atan2(ground.z + secondSquare * polarRadius * s * s * s,
                              across - kSquaredEccentricity * kEquatorRadius * c * c * c);
        parametric = std::atan2((1.0 - kFlattening) * std::sin(latitude), std::cos(latitude));
    }
    const double s = std::sin(latitude);
    const double c = std::cos(latitude);
    const double height = across * c + ground.z * s - kEquatorRadius * kEquatorRadius / normalLength(s);
    return {.latitude = Angle::fromRadians(latitude),
            .longitude = Angle::fromRadians(std::atan2(ground.y, ground.x)),
            .heightMetres = 1000.0 * height};
}

double LookAngles::dopplerFactor() const
{
    return 1.0 - kilometresPerSecond / kLightSpeed;
}

Observer::Observer(const Site& site)
{
    const double sinLatitude = std::sin(site.latitude.radians());
    const double cosLatitude = std::cos(site.latitude.radians());
    const double sinLongitude = std::sin(site.longitude.radians());
    const double cosLongitude = std::cos(site.longitude.radians());
    const double normal = normalLength(sinLatitude);
    const double height = site.heightMetres / 1000.0;
    m_east = {-sinLongitude, cosLongitude, 0.0};
    m_north = {-sinLatitude * cosLongitude, -sinLatitude * sinLongitude, cosLatitude};
    m_up = {cosLatitude * cosLongitude, cosLatitude * sinLongitude, sinLatitude};
    m_site = {(normal + height) * m_up.x, (normal + height) * m_up.y,
              (normal * (1.0 - kSquaredEccentricity) + height) * sinLatitude};
}

LookAngles Observer::look(const GroundState& satellite) const
{
    const Vector seen = satellite.position - m_site;
    const double east = dot(m_east, seen);
    const double north = dot(m_north, seen);
    const double up = dot(m_up, seen);
    const double range = length(seen);
    return {.direction = {.azimuth = Angle::fromRadians(std::atan2(east, north)).wrapped360(),
                          .elevation = Angle::fromRadians(std::atan2(up, std::sqrt(east * east + north * north)))},
            .kilometres = range,
            .kilometresPerSecond = range > 0.0 ? dot(seen, satellite.velocity) / range : 0.0};
}

Vector Observer::ground(const SkyPointing& direction, double kilometres) const
{
    const double level = kilometres * std::cos(direction.elevation.radians());
    return m_site + level * std::sin(direction.azimuth.radians()) * m_east +
           level * std::cos(direction.azimuth.radians()) * m_north +
           kilometres * std::sin(direction.elevation.radians()) * m_up;
}

}  // namespace boresight::orbit
