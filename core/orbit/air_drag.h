// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orbit/mean_orbit.h"

// The effect of the air on a mean orbit in SGP4: a power-law density whose terms C1…C5, D2…D4 depend on the height of
// the perigee. Below 220 km, and for deep space, only the terms of first order are used. Units of MeanOrbit.
// (Spacetrack Report 3, section 6; AIAA 2006-6753, appendix A.)
namespace boresight::orbit {

// It has more than 15 members: the coefficients of one theory, with the names of the theory.
class AirDrag
{
public:
    AirDrag(const MeanOrbit& orbit, const SecularRates& rates, bool isDeepSpace);

    struct Change
    {
        double axisRoot = 1.0;      // √(a / a at the epoch), without resonance
        double eccentricity = 0.0;  // to be subtracted
        double longitude = 0.0;     // rad
        double anomaly = 0.0;       // also to be subtracted from the argument of the perigee
        double node = 0.0;
    };
    // `anomaly`: the mean anomaly at that time, without drag.
    [[nodiscard]] Change after(double minutes, double anomaly) const;

private:
    void addHigherTerms(Change& change, double minutes, double anomaly) const;

    bool m_simple = true;
    double m_axis1 = 0.0;  // C1; the number is the power of the time
    double m_axis2 = 0.0;
    double m_axis3 = 0.0;
    double m_axis4 = 0.0;
    double m_eccentricity1 = 0.0;
    double m_eccentricityBySine = 0.0;
    double m_longitude2 = 0.0;
    double m_longitude3 = 0.0;
    double m_longitude4 = 0.0;
    double m_longitude5 = 0.0;
    double m_node2 = 0.0;
    double m_anomaly1 = 0.0;
    double m_anomalyByCube = 0.0;
    double m_eta = 0.0;  // η: where the density is greatest
    double m_cubeAtEpoch = 0.0;
    double m_sineAtEpoch = 0.0;
};

}  // namespace boresight::orbit
