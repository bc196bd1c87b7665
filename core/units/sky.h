// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <array>
#include <cstddef>
#include <span>

// Where the beam points, and where the axes stand: two types, because 370° and 10° are one direction but two places
// of the cable. MountModel is the only way from one to the other.
namespace boresight {

enum class Axis
{
    Azimuth,
    Elevation
};

inline constexpr std::array<Axis, 2> kAxes{Axis::Azimuth, Axis::Elevation};

// Some of kAxes, in their order.
using AxisSet = std::span<const Axis>;

[[nodiscard]] constexpr AxisSet axesIf(bool azimuth, bool elevation)
{
    return AxisSet(kAxes).subspan(azimuth ? 0U : 1U, (azimuth ? 1U : 0U) + (elevation ? 1U : 0U));
}

// Of an axis in what is kept for both.
[[nodiscard]] constexpr std::size_t index(Axis axis)
{
    return axis == Axis::Azimuth ? 0 : 1;
}

// A direction in the sky, seen from the mount. Azimuth from true north through east; elevation above the horizon,
// above 90° means over the top (the beam points to azimuth + 180°).
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

// Where an axis may be, ends included.
struct TravelRange
{
    Angle min;
    Angle max;

    [[nodiscard]] bool contains(Angle angle) const { return angle >= min && angle <= max; }
    [[nodiscard]] Angle clamped(Angle angle) const { return angle < min ? min : angle > max ? max : angle; }
    bool operator==(const TravelRange&) const = default;
};

}  // namespace boresight
