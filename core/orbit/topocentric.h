// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/julian_date.h"
#include "core/orbit/orbit_state.h"
#include "core/units/site.h"
#include "core/units/sky.h"

// From the frame of the elements to the direction seen from a site: geometric, without refraction, light time and
// aberration (together below 0.002° for low orbits). UTC is used for UT1, and polar motion is left out. Pure values,
// any thread. (AIAA 2006-6753, appendix C.)
namespace boresight::orbit {

// Earth-fixed: km, and km/s relative to the ground.
struct GroundState
{
    Vector position;
    Vector velocity;

    bool operator==(const GroundState&) const = default;
};

[[nodiscard]] GroundState groundState(const OrbitState& state, const JulianDate& utc);

// The place under the satellite on WGS-84, with the height of the satellite above it.
[[nodiscard]] Site subSatellitePoint(const Vector& ground);

struct LookAngles
{
    SkyPointing direction;             // azimuth [0°, 360°) from true north
    double kilometres = 0.0;           // range
    double kilometresPerSecond = 0.0;  // range rate: positive if the satellite recedes

    // Received frequency divided by transmitted frequency, to first order.
    [[nodiscard]] double dopplerFactor() const;

    bool operator==(const LookAngles&) const = default;
};

class Observer
{
public:
    explicit Observer(const Site& site);

    [[nodiscard]] LookAngles look(const GroundState& satellite) const;
    // The Earth-fixed position of a body, from its direction and distance at this site.
    [[nodiscard]] Vector ground(const SkyPointing& direction, double kilometres) const;

private:
    Vector m_site;
    Vector m_east;
    Vector m_north;
    Vector m_up;
};

}  // namespace boresight::orbit
