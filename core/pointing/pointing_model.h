// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

// How the true direction of the beam differs from what the axes show: the zero points of both axes, a mast that is not
// plumb, a beam and axes that are not at right angles, and gravity. No sum of small corrections but a chain of
// rotations, so that the way back is exact everywhere, also at the zenith and over the top. Pure values, any thread.
//
// To first order, A and E being azimuth and elevation of the axes after their offsets:
//   true azimuth   = A + (tiltEast cos A - tiltNorth sin A) tan E + collimation / cos E + nonPerpendicularity tan E
//   true elevation = E - tiltNorth cos A - tiltEast sin A - elevationSag cos E
// These are the terms of TPOINT (P. T. Wallace), there IA = -azimuthOffset, IE = elevationOffset, AN = tiltNorth,
// AW = -tiltEast, CA = -collimation, NPAE = -nonPerpendicularity, TF = elevationSag. The model of Haystack (Meeks, Ball
// and Hull, IEEE Trans. AP-16, 1968) and that of the VLBI Field System (Himwich, 1993; P1, P7, P5, P6, P4, P3, P8) have
// the same seven. Gravity has no term in azimuth: it pulls in the plane in which a vertical mount moves its elevation.
namespace boresight::pointing {

struct PointingTerms
{
    Angle azimuthOffset;        // the true azimuth where the axis shows 0°; any angle
    Angle elevationOffset;      // the true elevation where the axis shows 0°
    Angle tiltNorth;            // the azimuth axis leans to the north
    Angle tiltEast;             // and to the east
    Angle collimation;          // the beam looks past the right angle to the elevation axis, clockwise
    Angle nonPerpendicularity;  // the elevation axis leans: a beam to the zenith is moved clockwise
    Angle elevationSag;         // how much lower the beam hangs at the horizon than at the zenith

    bool operator==(const PointingTerms&) const = default;
};

// Where the axes look into a direction. A collimation keeps a beam from its zenith, as a hole of that size.
struct Aim
{
    AxisPosition axes;
    Angle miss;  // by how much the nearest place of the axes looks past a direction in that hole; else zero

    [[nodiscard]] bool exact() const { return miss == Angle{}; }
};

class PointingModel
{
public:
    PointingModel() = default;  // the axes show the truth; every value is passed through as it is
    explicit PointingModel(const PointingTerms& terms);

    [[nodiscard]] const PointingTerms& terms() const { return m_terms; }
    [[nodiscard]] bool isIdentity() const { return m_terms == PointingTerms{}; }
    // More than offsets and sag: then azimuth and elevation depend on each other.
    [[nodiscard]] bool isSkewed() const { return skew() != Angle{}; }
    // As far as tilt, collimation and non-perpendicularity together can move the beam.
    [[nodiscard]] Angle skew() const;

    // Both ways keep what a direction alone does not tell: the turn of the azimuth, which is the one nearest to the
    // other azimuth ± the offset, and whether the beam looks over the top, which is an elevation above 90° on both
    // sides.
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
    Turn m_lean;            // towards where the azimuth axis leans
    Turn m_tilt;            // how much
    Turn m_collimation;
    Turn m_crossing;  // of the axes: the non-perpendicularity
};

// The direction as an observer reports it: azimuth in [0°, 360°), over the top turned to its place in the sky.
[[nodiscard]] SkyPointing upright(const SkyPointing& direction);

}  // namespace boresight::pointing
