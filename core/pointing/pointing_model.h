// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

// The difference between the true direction of the beam and the angles of the axes: the geometry of the mount, the zero
// points of both axes, a mast that is not vertical, a beam and axes that are not at right angles, and gravity. It is
// not a sum of small corrections but a chain of rotations, so the inverse is exact everywhere, also at the zenith and
// over the top. Pure values, any thread.
//
// To first order, with A and E as azimuth and elevation of the axes after their offsets:
//   true azimuth   = A + (tiltEast cos A - tiltNorth sin A) tan E + collimation / cos E + nonPerpendicularity tan E
//   true elevation = E - tiltNorth cos A - tiltEast sin A - elevationSag cos E
// These are the terms of TPOINT (P. T. Wallace): IA = -azimuthOffset, IE = elevationOffset, AN = tiltNorth,
// AW = -tiltEast, CA = -collimation, NPAE = -nonPerpendicularity, TF = elevationSag. The model of Haystack (Meeks, Ball
// and Hull, IEEE Trans. AP-16, 1968) and that of the VLBI Field System (Himwich, 1993; P1, P7, P5, P6, P4, P3, P8) have
// the same seven. Gravity has no term in azimuth: it acts in the plane in which a vertical mount moves its elevation.
namespace boresight::pointing {

// What the two axes of a mount turn about.
enum class Geometry
{
    AzimuthElevation,
    XY
};

// An X/Y mount has no hole at the zenith. Its lower axis X is horizontal and points to the azimuth `xAxis`. X carries
// the upper axis Y, which is perpendicular to X. With both at 0° the beam points to the zenith. A larger X leans the
// beam to the azimuth xAxis + 90°, a larger Y to xAxis. With A and E as true azimuth and elevation:
//   cos E cos (A - xAxis) = sin Y          towards the X axis
//   cos E sin (A - xAxis) = cos Y sin X    to its right
//   sin E                 = cos Y cos X    up
// So X = atan2(cos E sin (A - xAxis), sin E) and Y = asin(cos E cos (A - xAxis)). With xAxis 0° (north-south) these are
// the angles XEYN of CCSDS 503.0-B (Tracking Data Message), the mount XYNS of VLBI. With 90° they are XSYE, the mount
// XYEW. Both ends of the X axis (Y = ±90°) are the keyhole: a beam near the horizon in these two directions needs a
// rate of X that grows with 1 / cos Y.
struct MountGeometry
{
    Geometry kind = Geometry::AzimuthElevation;
    Angle xAxis{};  // true azimuth of one end of the X axis

    bool operator==(const MountGeometry&) const = default;
};

// The seven terms belong to an azimuth and an elevation axis. A mount of another geometry has none (profile/check.cpp).
struct PointingTerms
{
    Angle azimuthOffset;        // the true azimuth at the axis angle 0°; any angle
    Angle elevationOffset;      // the true elevation at the axis angle 0°
    Angle tiltNorth;            // the azimuth axis leans to the north
    Angle tiltEast;             // and to the east
    Angle collimation;          // clockwise angle of the beam from the right angle to the elevation axis
    Angle nonPerpendicularity;  // lean of the elevation axis: moves a beam at the zenith clockwise
    Angle elevationSag;         // how much lower the beam points at the horizon than at the zenith
    MountGeometry geometry{};   // not a term: what the angles of the axes mean

    bool operator==(const PointingTerms&) const = default;
};

// The axis angles for a direction. A collimation keeps the beam out of a hole of that size around the zenith.
struct Aim
{
    AxisPosition axes;
    Angle miss;  // the remaining error for a direction inside the hole; otherwise zero

    [[nodiscard]] bool exact() const { return miss == Angle{}; }
};

class PointingModel
{
public:
    PointingModel() = default;  // no terms: every value is passed through unchanged
    explicit PointingModel(const PointingTerms& terms);

    [[nodiscard]] const PointingTerms& terms() const { return m_terms; }
    [[nodiscard]] bool isIdentity() const { return m_terms == PointingTerms{}; }
    [[nodiscard]] bool isXY() const { return m_terms.geometry.kind == Geometry::XY; }
    // There are terms other than offsets and sag, or the axes are X and Y. Then azimuth and elevation depend on each
    // other.
    [[nodiscard]] bool isSkewed() const { return isXY() || skew() != Angle{}; }
    // The largest angle by which tilt, collimation and non-perpendicularity together can move the beam.
    [[nodiscard]] Angle skew() const;

    // Both conversions keep two things that a direction alone does not contain. One is the turn of the azimuth: the
    // result is on the turn nearest to the argument ± the offset. The other is the side of the zenith: an elevation
    // above 90° means over the top for both types. Angles of an X/Y mount contain neither: the direction is upright,
    // with X within ±180° and Y within ±90°.
    [[nodiscard]] SkyPointing toSky(const AxisPosition& axes) const;
    [[nodiscard]] Aim toAxes(const SkyPointing& direction) const;

    bool operator==(const PointingModel& other) const { return m_terms == other.m_terms; }

private:
    // North, east, up, of length 1.
    struct Vector
    {
        double north;
        double east;
        double up;
    };
    struct Turn
    {
        double sin = 0.0;
        double cos = 1.0;
    };
    [[nodiscard]] static Turn turn(Angle angle);
    [[nodiscard]] Vector leant(const Vector& v, double sinTilt) const;
    [[nodiscard]] Angle withSag(Angle mechanical) const;
    [[nodiscard]] Angle withoutSag(Angle elevation) const;
    [[nodiscard]] Angle missAt(const Vector& wanted) const;

    PointingTerms m_terms;
    Angle m_azimuthOffset;  // within half a turn
    Turn m_lean;            // direction of the lean of the azimuth axis
    Turn m_tilt;            // size of the lean
    Turn m_collimation;
    Turn m_crossing;  // of the axes: the non-perpendicularity
};

// The direction in observer's coordinates: azimuth in [0°, 360°), a direction over the top converted to its place in
// the sky.
[[nodiscard]] SkyPointing upright(const SkyPointing& direction);

}  // namespace boresight::pointing
