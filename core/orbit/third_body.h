// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orbit/mean_orbit.h"

// The effect of the Sun or the Moon on an orbit of deep space in SDP4: constant rates and periodic shifts. Units of
// MeanOrbit. (Hujsak, Spacetrack Report 1; Spacetrack Report 3, section 7; AIAA 2006-6753, appendix B.)
namespace boresight::orbit {

// The orbit of the Sun or the Moon about the Earth at the epoch of the elements.
struct BodyOrbit
{
    double strength = 0.0;  // of the perturbation
    double motion = 0.0;    // rad/min
    double eccentricity = 0.0;
    double anomaly = 0.0;     // mean, at the epoch
    double sinPerigee = 0.0;  // of the argument of the perigee
    double cosPerigee = 0.0;
    double sinInclination = 0.0;  // against the equator
    double cosInclination = 0.0;
    double sinNode = 0.0;  // from the equinox
    double cosNode = 0.0;
};

[[nodiscard]] BodyOrbit sunOrbit(const JulianDate& epoch);
[[nodiscard]] BodyOrbit moonOrbit(const JulianDate& epoch);

class ThirdBody
{
public:
    ThirdBody(const MeanOrbit& orbit, const BodyOrbit& body);

    struct Rates  // rad/min, per minute
    {
        double eccentricity = 0.0;
        double inclination = 0.0;
        double anomaly = 0.0;
        double perigee = 0.0;
        double node = 0.0;
    };
    [[nodiscard]] const Rates& rates() const { return m_rates; }

    // The periodic shifts, before they are applied to node and perigee.
    struct Shifts
    {
        double eccentricity = 0.0;
        double inclination = 0.0;
        double anomaly = 0.0;
        double perigeePlusNode = 0.0;  // ω + Ω cos i
        double nodeTimesSine = 0.0;    // Ω sin i
    };
    void addShifts(double minutes, Shifts& shifts) const;

private:
    struct Geometry;
    void setRates(const MeanOrbit& orbit, const Geometry& g);
    void setPeriodics(const MeanOrbit& orbit, const Geometry& g);

    // Factors of F2, F3 and sin f, where f is the true anomaly of the body.
    struct Factors
    {
        double f2 = 0.0;
        double f3 = 0.0;
        double sine = 0.0;
    };

    double m_motion = 0.0;
    double m_eccentricity = 0.0;
    double m_anomaly = 0.0;
    Rates m_rates;
    Factors m_onEccentricity;
    Factors m_onInclination;
    Factors m_onAnomaly;
    Factors m_onPerigee;
    Factors m_onNode;
};

}  // namespace boresight::orbit
