// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orbit/sgp4.h"
#include "core/orbit/topocentric.h"
#include "core/passes/pass.h"

#include <limits>

// An orbit as one site sees it, in seconds after the start of a search. For each moment it gives what the search needs:
// the distance from the minimum elevation, whether the satellite climbs, and how long it surely stays down. It counts
// its propagations. One thread.
namespace boresight::passes {

struct SkyMoment
{
    double seconds = 0.0;
    orbit::Vector ground;        // km, Earth-fixed
    double sineElevation = 0.0;  // of the elevation
    double above = 0.0;          // km above the cone of the minimum elevation; positive: the satellite is up
    double aboveRate = 0.0;      // km/s
    double climb = 0.0;          // has the sign of the elevation rate, and is nearly linear around a maximum
    double swing = 0.0;          // rad/s across the sky

    // The angle at the centre of the Earth between the satellite and the vertical of the site.
    double apart = 0.0;   // rad
    double reach = 0.0;   // rad: with a larger angle the satellite is not up. Valid for one revolution
    double hurry = 0.0;   // rad/s: largest rate of the angle
    double motion = 0.0;  // rad/s: mean motion
    double step = 0.0;    // s: contains at most one maximum of the elevation

    [[nodiscard]] bool isUp() const { return above > 0.0; }
    [[nodiscard]] bool climbs() const { return climb > 0.0; }
    // For this time the satellite surely stays down, s.
    [[nodiscard]] double rest() const { return (apart - reach) / hurry; }
};

// False only if the satellite surely stays down between the two moments.
[[nodiscard]] bool mayBeUpBetween(const SkyMoment& a, const SkyMoment& b);

// It has more than 15 members: constants of the site and the orbit that are computed once.
class SkyTrack
{
public:
    SkyTrack(const orbit::Sgp4& orbit, const PassSearch& search);

    // Empty if SGP4 has no answer. The earliest such time is kept in faultSeconds().
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
    orbit::Vector m_site;   // km, Earth-fixed
    orbit::Vector m_up;     // the vertical
    double m_siteHeight;    // km, distance of the site's horizontal plane from the centre of the Earth
    double m_siteRadius;    // km
    double m_siteTurn;      // rad/s, rotation of the vertical
    orbit::ResonanceState m_resonance;
    double m_faultSeconds = std::numeric_limits<double>::infinity();
    orbit::OrbitFault m_fault = orbit::OrbitFault::Decayed;
    long m_propagations = 0;
};

}  // namespace boresight::passes
