// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/julian_date.h"
#include "core/orbit/orbit_state.h"
#include "core/units/site.h"
#include "core/units/sky.h"

// From the frame of the elements to what a site sees: geometric and airless, without light time and aberration (below
// 0.002° for low orbits). UT1 is taken as UTC and the pole as standing still. Pure values, any thread.
// (AIAA 2006-6753, appendix C.)
namespace boresight::orbit {

// Fixed to the Earth: kilometres, and kilometres per second against the ground.
struct GroundState
{
    Vector position;
    Vector velocity;

    bool operator==(const GroundState&) const = default;
};

[[nodiscard]] GroundState groundState(const OrbitState& state, const JulianDate& utc);

// The place of WGS-84 under the satellite, with the height of the satellite above it.
[[nodiscard]] Site subSatellitePoint(const Vector& ground);

struct LookAngles
{
    SkyPointing direction;             // azimuth [0°, 360°) from true north
    double kilometres = 0.0;           // range
    double kilometresPerSecond = 0.0;  // of the range: above 0 it recedes

    // What a received frequency is of the transmitted one, to first order.
    [[nodiscard]] double dopplerFactor() const;

    bool operator==(const LookAngles&) const = default;
};

class Observer
{
public:
    explicit Observer(const Site& site);

    [[nodiscard]] LookAngles look(const GroundState& satellite) const;
    // The place of a body that this site sees in a direction, at a distance.
    [[nodiscard]] Vector ground(const SkyPointing& direction, double kilometres) const;

private:
    Vector m_site;
    Vector m_east;
    Vector m_north;
    Vector m_up;
};

}  // namespace boresight::orbit
