// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <array>
#include <cstddef>
#include <span>

// The direction of the beam and the position of the axes are two types, because 370° and 10° are the same direction but
// two positions of the cable. Only MountModel converts between them.
namespace boresight {

// The lower and the upper axis of the mount. On an X/Y mount (pointing::MountGeometry) they are X and Y.
enum class Axis
{
    Azimuth,
    Elevation
};

inline constexpr std::array<Axis, 2> kAxes{Axis::Azimuth, Axis::Elevation};

// A part of kAxes, in the same order.
using AxisSet = std::span<const Axis>;

[[nodiscard]] constexpr AxisSet axesIf(bool azimuth, bool elevation)
{
    return AxisSet(kAxes).subspan(azimuth ? 0U : 1U, (azimuth ? 1U : 0U) + (elevation ? 1U : 0U));
}

// The index of an axis in an array for both axes.
[[nodiscard]] constexpr std::size_t index(Axis axis)
{
    return axis == Axis::Azimuth ? 0 : 1;
}

// A direction in the sky, seen from the mount. Azimuth from true north through east. Elevation above the horizon; above
// 90° means over the top (the beam points to azimuth + 180°).
struct SkyPointing
{
    Angle azimuth;
    Angle elevation;

    bool operator==(const SkyPointing&) const = default;
};

// Mechanical angles of the two axes, unwrapped and continuous: 370° is not 10°.
struct AxisPosition
{
    Angle azimuth;
    Angle elevation;

    bool operator==(const AxisPosition&) const = default;
};

struct AxisRates
{
    AngularRate azimuth;
    AngularRate elevation;

    bool operator==(const AxisRates&) const = default;
};

// The permitted range of an axis, ends included.
struct TravelRange
{
    Angle min;
    Angle max;

    [[nodiscard]] bool contains(Angle angle) const { return angle >= min && angle <= max; }
    [[nodiscard]] Angle clamped(Angle angle) const { return angle < min ? min : angle > max ? max : angle; }
    bool operator==(const TravelRange&) const = default;
};

}  // namespace boresight
