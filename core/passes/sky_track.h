// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orbit/sgp4.h"
#include "core/orbit/topocentric.h"
#include "core/passes/pass.h"

#include <limits>

// An orbit as one site sees it, in seconds after the start of a search, with what the search needs to know of a moment:
// the way to the minimum elevation, whether the satellite climbs, and how long nothing can happen. It counts its
// propagations. One thread.
namespace boresight::passes {

struct SkyMoment
{
    double seconds = 0.0;
    orbit::Vector ground;        // km, fixed to the Earth
    double sineElevation = 0.0;  // of the elevation
    double above = 0.0;          // km from the cone of the minimum elevation: above 0 it is up
    double aboveRate = 0.0;      // km/s
    double climb = 0.0;          // has the sign of the rate of the elevation, and is nearly straight around a maximum
    double swing = 0.0;          // rad/s across the sky

    // Of the angle at the centre of the Earth between the satellite and the vertical of the site.
    double apart = 0.0;   // rad
    double reach = 0.0;   // rad: where it is greater, the satellite is not up. Holds for a turn of the orbit
    double hurry = 0.0;   // rad/s: it never changes faster
    double motion = 0.0;  // rad/s: the mean one
    double step = 0.0;    // s: the elevation has no more than one maximum in it

    [[nodiscard]] bool isUp() const { return above > 0.0; }
    [[nodiscard]] bool climbs() const { return climb > 0.0; }
    // The satellite does not come up within this time, s.
    [[nodiscard]] double rest() const { return (apart - reach) / hurry; }
};

// False only if the satellite is surely down from the one to the other.
[[nodiscard]] bool mayBeUpBetween(const SkyMoment& a, const SkyMoment& b);

// More than 15 members: what is the same at each moment of the site and the orbit, worked out once.
class SkyTrack
{
public:
    SkyTrack(const orbit::Sgp4& orbit, const PassSearch& search);

    // A fault is remembered: the earliest one that was met.
    [[nodiscard]] std::optional<SkyMoment> at(double seconds);
    [[nodiscard]] double faultSeconds() const { return m_faultSeconds; }
    [[nodiscard]] orbit::OrbitFault fault() const { return m_fault; }
    [[nodiscard]] long propagations() const { return m_propagations; }

    [[nodiscard]] UtcTime utc(double seconds) const;
    [[nodiscard]] SkyPointing direction(const SkyMoment& moment) const;
    [[nodiscard]] PassMoment passMoment(const SkyMoment& moment) const;

private:
    void addReach(const orbit::OrbitState& state, SkyMoment& moment) const;

    orbit::Sgp4 m_orbit;
    orbit::Observer m_observer;
    UtcTime m_start;
    double m_startMinutes;  // after the epoch
    double m_startAngle;    // of the Earth, rad
    double m_rotation;      // rad/s
    double m_sineLimit;     // of the minimum elevation
    orbit::Vector m_site;   // km, fixed to the Earth
    orbit::Vector m_up;     // the vertical
    double m_siteHeight;    // km, of the level plane of the site over the centre
    double m_siteRadius;    // km
    double m_siteTurn;      // rad/s, of the vertical
    orbit::ResonanceState m_resonance;
    double m_faultSeconds = std::numeric_limits<double>::infinity();
    orbit::OrbitFault m_fault = orbit::OrbitFault::Decayed;
    long m_propagations = 0;
};

}  // namespace boresight::passes
