// SPDX-License-Identifier: GPL-3.0-or-later
// The chain of rotations from the axes to the sky. The collimation turns the beam away from the right angle to the
// elevation axis. Then the beam is turned about the elevation axis by the elevation. The elevation axis leans by the
// non-perpendicularity. The result is turned about the azimuth axis by the azimuth, and leans with the mast. `forward`,
// `right` and `up` are the beam in the frame of the turning mount.
#include "core/pointing/pointing_model.h"

#include "core/pointing/ranges.h"

#include <cmath>

namespace boresight::pointing {

namespace {

// Near the zenith of a leaning mount, axis and beam may differ by half a turn. Then two turns are equally near. toSky()
// takes the lower and toAxes() the upper of them, so that the turn is kept in spite of rounding.
constexpr Angle kBelow = Angle::fromDegrees(1e-6);

Angle angleOf(double y, double x)
{
    return Angle::fromRadians(std::atan2(y, x));
}

// A direction on a globe whose pole is at `latitude` 90°. Both angles of the mount and of the sky are of this kind.
struct OnGlobe
{
    Angle longitude;
    Angle latitude;
};

// Turns the globe so that its pole and the place of longitude 0° on its equator change places. This is its own inverse.
// It brings the zenith, the pole of the sky, to X = Y = 0, and the X axis, in azimuth 0°, to the pole of X and Y.
OnGlobe swapped(const OnGlobe& place)
{
    const double sinLongitude = std::sin(place.longitude.radians());
    const double cosLongitude = std::cos(place.longitude.radians());
    const double up = std::sin(place.latitude.radians());
    const double level = std::cos(place.latitude.radians());
    const double across = level * sinLongitude;
    return {.longitude = angleOf(across, up), .latitude = angleOf(level * cosLongitude, std::hypot(across, up))};
}

}  // namespace

PointingModel::Turn PointingModel::turn(Angle angle)
{
    return {.sin = std::sin(angle.radians()), .cos = std::cos(angle.radians())};
}

PointingModel::PointingModel(const PointingTerms& terms)
    : m_terms(terms),
      m_azimuthOffset(terms.azimuthOffset.wrapped180()),
      m_lean(turn(angleOf(terms.tiltEast.radians(), terms.tiltNorth.radians()))),
      m_tilt(turn(Angle::fromRadians(std::hypot(terms.tiltNorth.radians(), terms.tiltEast.radians())))),
      m_collimation(turn(terms.collimation)),
      m_crossing(turn(terms.nonPerpendicularity))
{}

Angle PointingModel::skew() const
{
    return Angle::fromRadians(std::hypot(m_terms.tiltNorth.radians(), m_terms.tiltEast.radians())) +
           abs(m_terms.collimation) + abs(m_terms.nonPerpendicularity);
}

// Turns the vector about the horizontal line across the lean, as the mast is turned. A negated sine turns it back.
PointingModel::Vector PointingModel::leant(const Vector& v, double sinTilt) const
{
    const double along = v.north * m_lean.cos + v.east * m_lean.sin;
    const double across = v.east * m_lean.cos - v.north * m_lean.sin;
    const double turned = along * m_tilt.cos + v.up * sinTilt;
    return {.north = turned * m_lean.cos - across * m_lean.sin,
            .east = turned * m_lean.sin + across * m_lean.cos,
            .up = v.up * m_tilt.cos - along * sinTilt};
}

// The sag depends on the cosine of the final elevation of the beam. Newton's method: a sag of 10° takes five steps.
Angle PointingModel::withSag(Angle mechanical) const
{
    constexpr int kSteps = 8;
    const double straight = (mechanical + m_terms.elevationOffset).radians();
    const double sag = m_terms.elevationSag.radians();
    double hanging = straight;
    for (int i = 0; i < kSteps && sag != 0.0; ++i) {
        hanging -= (hanging + sag * std::cos(hanging) - straight) / (1.0 - sag * std::sin(hanging));
    }
    return Angle::fromRadians(hanging);
}

Angle PointingModel::withoutSag(Angle elevation) const
{
    return elevation + std::cos(elevation.radians()) * m_terms.elevationSag - m_terms.elevationOffset;
}

SkyPointing PointingModel::toSky(const AxisPosition& axes) const
{
    if (isXY()) {
        const auto [azimuth, elevation] = swapped({.longitude = axes.azimuth, .latitude = axes.elevation});
        return {.azimuth = (azimuth + m_terms.geometry.xAxis).wrapped360(), .elevation = elevation};
    }
    if (isIdentity()) {
        return {.azimuth = axes.azimuth, .elevation = axes.elevation};
    }
    const Angle azimuth = axes.azimuth + m_azimuthOffset;
    const Turn around = turn(azimuth);
    const Turn above = turn(withSag(axes.elevation));
    const double forward = m_collimation.cos * above.cos;
    const double raised = m_collimation.cos * above.sin;
    const double right = m_collimation.sin * m_crossing.cos + raised * m_crossing.sin;
    const Vector beam = leant({.north = forward * around.cos - right * around.sin,
                               .east = forward * around.sin + right * around.cos,
                               .up = raised * m_crossing.cos - m_collimation.sin * m_crossing.sin},
                              m_tilt.sin);
    const Angle elevation = angleOf(beam.up, std::hypot(beam.north, beam.east));
    if (forward < 0.0) {
        return {.azimuth = angleOf(-beam.east, -beam.north).nearestTo(azimuth - kBelow),
                .elevation = 180_deg - elevation};
    }
    return {.azimuth = angleOf(beam.east, beam.north).nearestTo(azimuth - kBelow), .elevation = elevation};
}

Aim PointingModel::toAxes(const SkyPointing& direction) const
{
    if (isXY()) {
        const auto [x, y] =
            swapped({.longitude = direction.azimuth - m_terms.geometry.xAxis, .latitude = direction.elevation});
        return {.axes = {.azimuth = x, .elevation = y}, .miss = {}};
    }
    if (isIdentity()) {
        return {.axes = {.azimuth = direction.azimuth, .elevation = direction.elevation}, .miss = {}};
    }
    const Turn around = turn(direction.azimuth);
    const Turn above = turn(direction.elevation);
    const Vector beam =
        leant({.north = above.cos * around.cos, .east = above.cos * around.sin, .up = above.sin}, -m_tilt.sin);
    const double raised = (beam.up + m_collimation.sin * m_crossing.sin) / m_crossing.cos;
    const double right = m_collimation.sin * m_crossing.cos + raised * m_crossing.sin;
    // Computed from the horizontal part, because `raised` hardly changes near the zenith.
    const double level = std::hypot(beam.north, beam.east);
    const double ahead = std::sqrt(std::fmax((level - right) * (level + right), 0.0));
    const bool overTheTop = direction.elevation > 90_deg;
    const Angle azimuth =
        angleOf(beam.east, beam.north) - angleOf(right, overTheTop ? -ahead : ahead) - m_azimuthOffset;
    const Angle elevation = overTheTop ? 180_deg - angleOf(raised, ahead) : angleOf(raised, ahead);
    return {.axes = {.azimuth = azimuth.nearestTo(direction.azimuth - m_azimuthOffset + kBelow),
                     .elevation = withoutSag(elevation)},
            .miss = ahead > 0.0 ? Angle{} : missAt(beam)};
}

// How much nearer to the zenith (or nadir) of the mount a direction is than the beam can get.
Angle PointingModel::missAt(const Vector& wanted) const
{
    const double raised = std::copysign(m_collimation.cos, wanted.up);
    const double right = m_collimation.sin * m_crossing.cos + raised * m_crossing.sin;
    const double up = raised * m_crossing.cos - m_collimation.sin * m_crossing.sin;
    const Angle miss = abs(angleOf(std::abs(right), up) - angleOf(std::hypot(wanted.north, wanted.east), wanted.up));
    return miss > kRounding ? miss : Angle{};
}

SkyPointing upright(const SkyPointing& direction)
{
    if (direction.elevation > 90_deg) {
        return {.azimuth = (direction.azimuth + 180_deg).wrapped360(), .elevation = 180_deg - direction.elevation};
    }
    return {.azimuth = direction.azimuth.wrapped360(), .elevation = direction.elevation};
}

}  // namespace boresight::pointing
