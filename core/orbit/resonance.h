// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orbit/mean_orbit.h"

#include <array>
#include <cstddef>
#include <optional>

// Orbits of one day and half a day pass the same longitudes again and again, so the irregular gravity of the Earth adds
// up. SDP4 integrates their longitude in steps of 720 min from the epoch. Units of MeanOrbit. (Hujsak, Spacetrack
// Report 1; AIAA 2006-6753, appendix B.)
namespace boresight::orbit {

// The progress of the integration. A default value begins at the epoch. Use one value for one orbit and one thread.
// Calls in the order of time then need not integrate from the epoch again. The results are the same without it.
struct ResonanceState
{
    bool isBegun = false;
    double minutes = 0.0;
    double longitude = 0.0;
    double motion = 0.0;
    double longitudeRate = 0.0;  // the derivatives at that time
    double motionRate = 0.0;
    double motionBend = 0.0;
};

class Resonance
{
public:
    struct Rates  // rad/min, from all causes together
    {
        double anomaly = 0.0;
        double perigee = 0.0;
        double node = 0.0;
        double perigeeByEarth = 0.0;  // the part that the oblate Earth causes
    };

    // Empty if the orbit has no resonance. `siderealTime`: at the epoch.
    [[nodiscard]] static std::optional<Resonance> of(const MeanOrbit& orbit, const Rates& rates, double siderealTime);

    struct Motion
    {
        double motion = 0.0;
        double anomaly = 0.0;
    };
    // `node`, `perigee`: the mean values at that time.
    [[nodiscard]] Motion at(double minutes, double node, double perigee, ResonanceState& state) const;

private:
    // One harmonic of the force: amplitude · sin(longitude · λ + perigee · ω - phase).
    struct Term
    {
        double amplitude = 0.0;
        double longitude = 0.0;
        double perigee = 0.0;
        double phase = 0.0;
    };

    Resonance(const MeanOrbit& orbit, const Rates& rates, double siderealTime, bool isOneDay);

    void addOneDayTerms(const MeanOrbit& orbit);
    void addHalfDayTerms(const MeanOrbit& orbit);
    void add(const Term& term) { m_terms[m_count++] = term; }
    void differentiate(ResonanceState& state) const;

    bool m_isOneDay = false;
    double m_siderealTime = 0.0;
    double m_longitude = 0.0;  // λ at the epoch
    double m_motion = 0.0;
    double m_drift = 0.0;  // of λ, in addition to the mean motion
    double m_perigee = 0.0;
    double m_perigeeRate = 0.0;
    std::array<Term, 10> m_terms;
    std::size_t m_count = 0;
};

}  // namespace boresight::orbit
