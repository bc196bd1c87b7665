// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orbit/resonance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace boresight::orbit {

namespace {

constexpr double kEarthRotation = 4.37526908801129966e-3;  // rad/min
constexpr double kStep = 720.0;                            // min

bool isOneDay(const MeanOrbit& orbit)
{
    return orbit.motion > 0.0034906585 && orbit.motion < 0.0052359877;
}

bool isHalfDay(const MeanOrbit& orbit)
{
    return orbit.motion >= 8.26e-3 && orbit.motion <= 9.24e-3 && orbit.eccentricity >= 0.5;
}

// A cubic polynomial in the eccentricity, constant term first.
struct Cubic
{
    std::array<double, 4> terms;

    [[nodiscard]] double at(double e) const { return terms[0] + e * (terms[1] + e * (terms[2] + e * terms[3])); }
};

// The eccentricity functions G(l, p, q), fitted for the eccentricities of half-day orbits.
struct EccentricityFunctions
{
    double g201, g211, g310, g322, g410, g422, g520, g521, g532, g533;
};

void setLowTo065(EccentricityFunctions& g, double e)
{
    g.g211 = Cubic{{3.616, -13.2470, 16.2900, 0.0}}.at(e);
    g.g310 = Cubic{{-19.302, 117.3900, -228.4190, 156.5910}}.at(e);
    g.g322 = Cubic{{-18.9068, 109.7927, -214.6334, 146.5816}}.at(e);
    g.g410 = Cubic{{-41.122, 242.6940, -471.0940, 313.9530}}.at(e);
    g.g422 = Cubic{{-146.407, 841.8800, -1629.014, 1083.4350}}.at(e);
    g.g520 = Cubic{{-532.114, 3017.977, -5740.032, 3708.2760}}.at(e);
}

void setLowFrom065(EccentricityFunctions& g, double e)
{
    g.g211 = Cubic{{-72.099, 331.819, -508.738, 266.724}}.at(e);
    g.g310 = Cubic{{-346.844, 1582.851, -2415.925, 1246.113}}.at(e);
    g.g322 = Cubic{{-342.585, 1554.908, -2366.899, 1215.972}}.at(e);
    g.g410 = Cubic{{-1052.797, 4758.686, -7193.992, 3651.957}}.at(e);
    g.g422 = Cubic{{-3581.690, 16178.110, -24462.770, 12422.520}}.at(e);
    g.g520 = e > 0.715 ? Cubic{{-5149.66, 29936.92, -54087.36, 31324.56}}.at(e)
                       : Cubic{{1464.74, -4664.75, 3763.64, 0.0}}.at(e);
}

void setHigh(EccentricityFunctions& g, double e)
{
    if (e < 0.7) {
        g.g533 = Cubic{{-919.22770, 4988.6100, -9064.7700, 5542.21}}.at(e);
        g.g521 = Cubic{{-822.71072, 4568.6173, -8491.4146, 5337.524}}.at(e);
        g.g532 = Cubic{{-853.66600, 4690.2500, -8624.7700, 5341.4}}.at(e);
    } else {
        g.g533 = Cubic{{-37995.780, 161616.52, -229838.20, 109377.94}}.at(e);
        g.g521 = Cubic{{-51752.104, 218913.95, -309468.16, 146349.42}}.at(e);
        g.g532 = Cubic{{-40023.880, 170470.89, -242699.48, 115605.82}}.at(e);
    }
}

EccentricityFunctions eccentricityFunctions(double e)
{
    EccentricityFunctions g{};
    g.g201 = -0.306 - (e - 0.64) * 0.440;
    if (e <= 0.65) {
        setLowTo065(g, e);
    } else {
        setLowFrom065(g, e);
    }
    setHigh(g, e);
    return g;
}

// The inclination functions F(l, m, p) of half-day orbits.
struct InclinationFunctions
{
    InclinationFunctions(double s, double c)
    {
        const double s2 = s * s;
        const double c2 = c * c;
        f220 = 0.75 * (1.0 + 2.0 * c + c2);
        f221 = 1.5 * s2;
        f321 = 1.875 * s * (1.0 - 2.0 * c - 3.0 * c2);
        f322 = -1.875 * s * (1.0 + 2.0 * c - 3.0 * c2);
        f441 = 35.0 * s2 * f220;
        f442 = 39.3750 * s2 * s2;
        f522 = 9.84375 * s * (s2 * (1.0 - 2.0 * c - 5.0 * c2) + 0.33333333 * (-2.0 + 4.0 * c + 6.0 * c2));
        f523 = s * (4.92187512 * s2 * (-2.0 - 4.0 * c + 10.0 * c2) + 6.56250012 * (1.0 + 2.0 * c - 3.0 * c2));
        f542 = 29.53125 * s * (2.0 - 8.0 * c + c2 * (-12.0 + 8.0 * c + 10.0 * c2));
        f543 = 29.53125 * s * (-2.0 - 8.0 * c + c2 * (12.0 + 8.0 * c - 10.0 * c2));
    }

    double f220, f221, f321, f322, f441, f442, f522, f523, f542, f543;
};

}  // namespace

std::optional<Resonance> Resonance::of(const MeanOrbit& orbit, const Rates& rates, double siderealTime)
{
    if (isOneDay(orbit)) {
        return Resonance(orbit, rates, siderealTime, true);
    }
    if (isHalfDay(orbit)) {
        return Resonance(orbit, rates, siderealTime, false);
    }
    return std::nullopt;
}

Resonance::Resonance(const MeanOrbit& orbit, const Rates& rates, double siderealTime, bool isOneDay)
    : m_isOneDay(isOneDay),
      m_siderealTime(siderealTime),
      m_motion(orbit.motion),
      m_perigee(orbit.perigee),
      m_perigeeRate(rates.perigeeByEarth)
{
    if (isOneDay) {
        m_longitude = orbit.anomaly + orbit.node + orbit.perigee - siderealTime;
        m_drift = rates.anomaly + rates.perigee + rates.node - kEarthRotation - orbit.motion;
        addOneDayTerms(orbit);
    } else {
        m_longitude = orbit.anomaly + 2.0 * (orbit.node - siderealTime);
        m_drift = rates.anomaly + 2.0 * (rates.node - kEarthRotation) - orbit.motion;
        addHalfDayTerms(orbit);
    }
    m_longitude = std::remainder(m_longitude, 2.0 * std::numbers::pi);
}

void Resonance::addOneDayTerms(const MeanOrbit& orbit)
{
    constexpr double kQ22 = 1.7891679e-6;
    constexpr double kQ31 = 2.1460748e-6;
    constexpr double kQ33 = 2.2123015e-7;
    const double e2 = orbit.eccentricity * orbit.eccentricity;
    const double c = orbit.cosInclination;
    const double g200 = 1.0 + e2 * (-2.5 + 0.8125 * e2);
    const double g310 = 1.0 + 2.0 * e2;
    const double g300 = 1.0 + e2 * (-6.0 + 6.60937 * e2);
    const double f220 = 0.75 * (1.0 + c) * (1.0 + c);
    const double f311 = 0.9375 * orbit.sinInclination * orbit.sinInclination * (1.0 + 3.0 * c) - 0.75 * (1.0 + c);
    const double f330 = 1.875 * (1.0 + c) * (1.0 + c) * (1.0 + c);
    const double near = 1.0 / orbit.axis;
    const double scale = 3.0 * orbit.motion * orbit.motion * near * near;
    add({scale * f311 * g310 * kQ31 * near, 1.0, 0.0, 0.13130908});
    add({2.0 * scale * f220 * g200 * kQ22, 2.0, 0.0, 2.0 * 2.8843198});
    add({3.0 * scale * f330 * g300 * kQ33 * near, 3.0, 0.0, 3.0 * 0.37448087});
}

void Resonance::addHalfDayTerms(const MeanOrbit& orbit)
{
    constexpr double kRoot22 = 1.7891679e-6;
    constexpr double kRoot32 = 3.7393792e-7;
    constexpr double kRoot44 = 7.3636953e-9;
    constexpr double kRoot52 = 1.1428639e-7;
    constexpr double kRoot54 = 2.1765803e-9;
    constexpr double kG22 = 5.7686396;  // phases of the harmonics
    constexpr double kG32 = 0.95240898;
    constexpr double kG44 = 1.8014998;
    constexpr double kG52 = 1.0508330;
    constexpr double kG54 = 4.4108898;
    const EccentricityFunctions g = eccentricityFunctions(orbit.eccentricity);
    const InclinationFunctions f(orbit.sinInclination, orbit.cosInclination);
    const double near = 1.0 / orbit.axis;
    const double second = 3.0 * orbit.motion * orbit.motion * near * near;
    const double third = second * near;
    const double fourth = third * near;
    const double fifth = fourth * near;
    add({second * kRoot22 * f.f220 * g.g201, 1.0, 2.0, kG22});
    add({second * kRoot22 * f.f221 * g.g211, 1.0, 0.0, kG22});
    add({third * kRoot32 * f.f321 * g.g310, 1.0, 1.0, kG32});
    add({third * kRoot32 * f.f322 * g.g322, 1.0, -1.0, kG32});
    add({2.0 * fourth * kRoot44 * f.f441 * g.g410, 2.0, 2.0, kG44});
    add({2.0 * fourth * kRoot44 * f.f442 * g.g422, 2.0, 0.0, kG44});
    add({fifth * kRoot52 * f.f522 * g.g520, 1.0, 1.0, kG52});
    add({fifth * kRoot52 * f.f523 * g.g532, 1.0, -1.0, kG52});
    add({2.0 * fifth * kRoot54 * f.f542 * g.g521, 2.0, 1.0, kG54});
    add({2.0 * fifth * kRoot54 * f.f543 * g.g533, 2.0, -1.0, kG54});
}

void Resonance::differentiate(ResonanceState& state) const
{
    const double perigee = m_perigee + m_perigeeRate * state.minutes;
    double rate = 0.0;
    double bend = 0.0;
    for (std::size_t i = 0; i < m_count; ++i) {
        const Term& term = m_terms[i];
        const double angle = term.longitude * state.longitude + term.perigee * perigee - term.phase;
        rate += term.amplitude * std::sin(angle);
        bend += term.amplitude * term.longitude * std::cos(angle);
    }
    state.longitudeRate = state.motion + m_drift;
    state.motionRate = rate;
    state.motionBend = bend * state.longitudeRate;
}

// The steps are at fixed times, so the result depends only on the time and not on earlier calls.
Resonance::Motion Resonance::at(double minutes, double node, double perigee, ResonanceState& state) const
{
    const bool isBehind = state.minutes * minutes < 0.0 || std::abs(minutes) < std::abs(state.minutes);
    if (!state.isBegun || isBehind) {
        state = {.isBegun = true, .longitude = m_longitude, .motion = m_motion};
        differentiate(state);
    }
    const double step = minutes < 0.0 ? -kStep : kStep;
    while (std::abs(minutes - state.minutes) >= kStep) {
        state.longitude += step * (state.longitudeRate + 0.5 * step * state.motionRate);
        state.motion += step * (state.motionRate + 0.5 * step * state.motionBend);
        state.minutes += step;
        differentiate(state);
    }
    const double rest = minutes - state.minutes;
    const double longitude = state.longitude + rest * (state.longitudeRate + 0.5 * rest * state.motionRate);
    const double turned = m_siderealTime + minutes * kEarthRotation;
    return {.motion = state.motion + rest * (state.motionRate + 0.5 * rest * state.motionBend),
            .anomaly = m_isOneDay ? longitude - node - perigee + turned : longitude - 2.0 * (node - turned)};
}

}  // namespace boresight::orbit
