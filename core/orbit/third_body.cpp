// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orbit/third_body.h"

#include "core/orbit/turn.h"

#include <cmath>
#include <numbers>

namespace boresight::orbit {

namespace {

constexpr double kNewYear1900 = 2415020.0;  // Julian date of 1900-01-00 12h, day 0 of the theory
// The obliquity of the ecliptic.
constexpr double kSinObliquity = 0.39785416;
constexpr double kCosObliquity = 0.91744867;

double daysSince1900(const JulianDate& epoch)
{
    return (epoch.day - kNewYear1900) + epoch.fraction;
}

// Converts the Moon's position on the ecliptic to the equator. The Moon's node goes round in 18.6 years.
struct MoonPlane
{
    explicit MoonPlane(double days)
    {
        constexpr double kSinTilt = 0.089683511;  // against the ecliptic
        const double nodeOnEcliptic = std::fmod(4.5236020 - 9.2422029e-4 * days, 2.0 * std::numbers::pi);
        const Turn ecliptic = turnOf(nodeOnEcliptic);
        cosInclination = 0.91375164 - 0.03568096 * ecliptic.cos;
        sinInclination = std::sqrt(1.0 - cosInclination * cosInclination);
        sinNode = kSinTilt * ecliptic.sin / sinInclination;
        cosNode = std::sqrt(1.0 - sinNode * sinNode);
        const double along = cosNode * ecliptic.cos + kCosObliquity * sinNode * ecliptic.sin;
        fromNode = std::atan2(kSinObliquity * ecliptic.sin / sinInclination, along) - nodeOnEcliptic;
    }

    double cosInclination;
    double sinInclination;
    double sinNode;
    double cosNode;
    double fromNode;  // the argument along the orbit minus the longitude along the ecliptic
};

}  // namespace

BodyOrbit sunOrbit(const JulianDate& epoch)
{
    const double days = daysSince1900(epoch);
    return {.strength = 2.9864797e-6,
            .motion = 1.19459e-5,
            .eccentricity = 0.01675,
            .anomaly = std::fmod(6.2565837 + 0.017201977 * days, 2.0 * std::numbers::pi),
            .sinPerigee = -0.98088458,
            .cosPerigee = 0.1945905,
            .sinInclination = kSinObliquity,
            .cosInclination = kCosObliquity,
            .sinNode = 0.0,
            .cosNode = 1.0};
}

BodyOrbit moonOrbit(const JulianDate& epoch)
{
    const double days = daysSince1900(epoch);
    const MoonPlane plane(days);
    const double perigee = 5.8351514 + 0.0019443680 * days;  // longitude of the perigee
    const Turn argument = turnOf(perigee + plane.fromNode);
    return {.strength = 4.7968065e-7,
            .motion = 1.5835218e-4,
            .eccentricity = 0.0549,
            .anomaly = std::fmod(4.7199672 + 0.22997150 * days - perigee, 2.0 * std::numbers::pi),
            .sinPerigee = argument.sin,
            .cosPerigee = argument.cos,
            .sinInclination = plane.sinInclination,
            .cosInclination = plane.cosInclination,
            .sinNode = plane.sinNode,
            .cosNode = plane.cosNode};
}

// The geometry between the orbit of the satellite and that of the body: a1…a10, X1…X8, Z and S of the report.
struct ThirdBody::Geometry
{
    Geometry(const MeanOrbit& orbit, const BodyOrbit& body);

    void setZ(double a1, double a2, double a3, double a4, double a5, double a6, const MeanOrbit& orbit);
    void setS(const MeanOrbit& orbit, double strength);

    double x1, x2, x3, x4, x5, x6, x7, x8;
    double z1, z2, z3, z11, z12, z13, z21, z22, z23, z31, z32, z33;
    double s1, s2, s3, s4, s5, s6, s7;
};

ThirdBody::Geometry::Geometry(const MeanOrbit& orbit, const BodyOrbit& body)
{
    const Turn node = turnOf(orbit.node);
    const Turn perigee = turnOf(orbit.perigee);
    const double cosNode = body.cosNode * node.cos + body.sinNode * node.sin;  // of the angle between both nodes
    const double sinNode = body.cosNode * node.sin - body.sinNode * node.cos;
    const double a1 = body.cosPerigee * cosNode + body.sinPerigee * body.cosInclination * sinNode;
    const double a3 = -body.sinPerigee * cosNode + body.cosPerigee * body.cosInclination * sinNode;
    const double a7 = -body.cosPerigee * sinNode + body.sinPerigee * body.cosInclination * cosNode;
    const double a8 = body.sinPerigee * body.sinInclination;
    const double a9 = body.sinPerigee * sinNode + body.cosPerigee * body.cosInclination * cosNode;
    const double a10 = body.cosPerigee * body.sinInclination;
    const double a2 = orbit.cosInclination * a7 + orbit.sinInclination * a8;
    const double a4 = orbit.cosInclination * a9 + orbit.sinInclination * a10;
    const double a5 = -orbit.sinInclination * a7 + orbit.cosInclination * a8;
    const double a6 = -orbit.sinInclination * a9 + orbit.cosInclination * a10;
    x1 = a1 * perigee.cos + a2 * perigee.sin;
    x2 = a3 * perigee.cos + a4 * perigee.sin;
    x3 = -a1 * perigee.sin + a2 * perigee.cos;
    x4 = -a3 * perigee.sin + a4 * perigee.cos;
    x5 = a5 * perigee.sin;
    x6 = a6 * perigee.sin;
    x7 = a5 * perigee.cos;
    x8 = a6 * perigee.cos;
    setZ(a1, a2, a3, a4, a5, a6, orbit);
    setS(orbit, body.strength);
}

void ThirdBody::Geometry::setZ(double a1, double a2, double a3, double a4, double a5, double a6, const MeanOrbit& orbit)
{
    const double e2 = orbit.eccentricity * orbit.eccentricity;
    z31 = 12.0 * x1 * x1 - 3.0 * x3 * x3;
    z32 = 24.0 * x1 * x2 - 6.0 * x3 * x4;
    z33 = 12.0 * x2 * x2 - 3.0 * x4 * x4;
    z1 = 6.0 * (a1 * a1 + a2 * a2) + (1.0 + e2) * z31;
    z2 = 12.0 * (a1 * a3 + a2 * a4) + (1.0 + e2) * z32;
    z3 = 6.0 * (a3 * a3 + a4 * a4) + (1.0 + e2) * z33;
    z11 = -6.0 * a1 * a5 + e2 * (-24.0 * x1 * x7 - 6.0 * x3 * x5);
    z12 = -6.0 * (a1 * a6 + a3 * a5) + e2 * (-24.0 * (x2 * x7 + x1 * x8) - 6.0 * (x3 * x6 + x4 * x5));
    z13 = -6.0 * a3 * a6 + e2 * (-24.0 * x2 * x8 - 6.0 * x4 * x6);
    z21 = 6.0 * a2 * a5 + e2 * (24.0 * x1 * x5 - 6.0 * x3 * x7);
    z22 = 6.0 * (a4 * a5 + a2 * a6) + e2 * (24.0 * (x2 * x5 + x1 * x6) - 6.0 * (x4 * x7 + x3 * x8));
    z23 = 6.0 * a4 * a6 + e2 * (24.0 * x2 * x6 - 6.0 * x4 * x8);
}

void ThirdBody::Geometry::setS(const MeanOrbit& orbit, double strength)
{
    const double round = std::sqrt(orbit.roundness);
    s3 = strength / orbit.motion;
    s2 = -0.5 * s3 / round;
    s4 = s3 * round;
    s1 = -15.0 * orbit.eccentricity * s4;
    s5 = x1 * x3 + x2 * x4;
    s6 = x2 * x3 + x1 * x4;
    s7 = x2 * x4 - x1 * x3;
}

ThirdBody::ThirdBody(const MeanOrbit& orbit, const BodyOrbit& body)
    : m_motion(body.motion), m_eccentricity(body.eccentricity), m_anomaly(body.anomaly)
{
    const Geometry g(orbit, body);
    setRates(orbit, g);
    setPeriodics(orbit, g);
}

void ThirdBody::setRates(const MeanOrbit& orbit, const Geometry& g)
{
    constexpr double kEquatorial = 5.2359877e-2;  // 3°: nearer to the equator the node rate is set to 0
    const double e2 = orbit.eccentricity * orbit.eccentricity;
    const bool isEquatorial = orbit.inclination < kEquatorial || orbit.inclination > std::numbers::pi - kEquatorial;
    m_rates.eccentricity = g.s1 * m_motion * g.s5;
    m_rates.inclination = g.s2 * m_motion * (g.z11 + g.z13);
    m_rates.anomaly = -m_motion * g.s3 * (g.z1 + g.z3 - 14.0 - 6.0 * e2);
    m_rates.node = isEquatorial ? 0.0 : -m_motion * g.s2 * (g.z21 + g.z23) / orbit.sinInclination;
    m_rates.perigee = g.s4 * m_motion * (g.z31 + g.z33 - 6.0) - orbit.cosInclination * m_rates.node;
}

void ThirdBody::setPeriodics(const MeanOrbit& orbit, const Geometry& g)
{
    const double e2 = orbit.eccentricity * orbit.eccentricity;
    m_onEccentricity = {2.0 * g.s1 * g.s6, 2.0 * g.s1 * g.s7, 0.0};
    m_onInclination = {2.0 * g.s2 * g.z12, 2.0 * g.s2 * (g.z13 - g.z11), 0.0};
    m_onAnomaly = {-2.0 * g.s3 * g.z2, -2.0 * g.s3 * (g.z3 - g.z1), -2.0 * g.s3 * (-21.0 - 9.0 * e2) * m_eccentricity};
    m_onPerigee = {2.0 * g.s4 * g.z32, 2.0 * g.s4 * (g.z33 - g.z31), -18.0 * g.s4 * m_eccentricity};
    m_onNode = {-2.0 * g.s2 * g.z22, -2.0 * g.s2 * (g.z23 - g.z21), 0.0};
}

void ThirdBody::addShifts(double minutes, Shifts& shifts) const
{
    const Turn mean = turnOf(m_anomaly + m_motion * minutes);
    const Turn body = turnedBy(mean, 2.0 * m_eccentricity * mean.sin);
    const double f2 = 0.5 * body.sin * body.sin - 0.25;
    const double f3 = -0.5 * body.sin * body.cos;
    const auto shift = [&](const Factors& on) { return on.f2 * f2 + on.f3 * f3 + on.sine * body.sin; };
    shifts.eccentricity += shift(m_onEccentricity);
    shifts.inclination += shift(m_onInclination);
    shifts.anomaly += shift(m_onAnomaly);
    shifts.perigeePlusNode += shift(m_onPerigee);
    shifts.nodeTimesSine += shift(m_onNode);
}

}  // namespace boresight::orbit
