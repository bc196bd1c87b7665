// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/orbit/vector.h"
#include "core/units/sky.h"

#include <vector>

// The directions that a client sent, as far as they show what it tracks. Pure values.
namespace boresight::recognise {

struct SentPoint
{
    UtcTime utc;  // when it arrived
    SkyPointing direction;

    bool operator==(const SentPoint&) const = default;
};

using SentPoints = std::vector<SentPoint>;  // in the order of time

// A vector of length 1, so that angles near the zenith and at north are like all others.
[[nodiscard]] orbit::Vector unitOf(const SkyPointing& direction);
[[nodiscard]] Angle angleBetween(const orbit::Vector& a, const orbit::Vector& b);

// From the first point to the last one.
[[nodiscard]] Angle travelOf(const SentPoints& points);
// How far ahead of its target the client may aim. A client with a threshold aims ahead to the edge of that threshold,
// so its points are up to twice the threshold apart.
[[nodiscard]] Angle leadOf(const SentPoints& points);
// The step of the numbers that the client sends: 1°, 0.1° or 0.01°.
[[nodiscard]] Angle stepOf(const SentPoints& points);
// All points are the same place at the horizon: the client waits for a rise.
[[nodiscard]] bool waitsAtHorizon(const SentPoints& points);
// The points are far enough apart to show a rate.
[[nodiscard]] bool showsMotion(const SentPoints& points);

}  // namespace boresight::recognise
