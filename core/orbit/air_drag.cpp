// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orbit/air_drag.h"

#include "core/orbit/earth_gravity.h"
#include "core/orbit/turn.h"

#include <cmath>

namespace boresight::orbit {

namespace {

constexpr double kFullDragHeight = 220.0;    // km, of the perigee: above it all terms are used
constexpr double kUsualHeight = 156.0;       // above it the density begins at a height of 78 km
constexpr double kLowHeight = 98.0;          // below it the density begins at 20 km
constexpr double kLeastEccentricity = 1e-4;  // below it the terms with the direction of the perigee are left out

struct Atmosphere
{
    double begins = 0.0;  // s, Earth radii from the centre
    double fourth = 0.0;  // (q0 - s)⁴
};

Atmosphere atmosphereAt(double perigeeHeight)
{
    constexpr double kTop = 120.0;  // q0, km
    const double begins = perigeeHeight >= kUsualHeight ? 78.0
                          : perigeeHeight >= kLowHeight ? perigeeHeight - 78.0
                                                        : 20.0;
    return {begins / kEarthRadius + 1.0, std::pow((kTop - begins) / kEarthRadius, 4.0)};
}

double cubed(double value)
{
    return value * value * value;
}

// The quantities from which all other terms are computed, with the names of the report.
struct DragTerms
{
    DragTerms(const MeanOrbit& orbit, const Atmosphere& air)
        : xi(1.0 / (orbit.axis - air.begins)),
          eta(orbit.axis * orbit.eccentricity * xi),
          eta2(eta * eta),
          eEta(orbit.eccentricity * eta),
          psi2(std::abs(1.0 - eta2)),
          strength(air.fourth * xi * xi * xi * xi),
          density(strength / std::pow(psi2, 3.5))
    {}

    double xi;  // ξ = 1 / (a - s)
    double eta;
    double eta2;
    double eEta;
    double psi2;
    double strength;  // (q0 - s)⁴ ξ⁴
    double density;
};

double c2(const MeanOrbit& orbit, const DragTerms& d)
{
    const double tilt = 3.0 * orbit.cosInclination * orbit.cosInclination - 1.0;
    return d.density * orbit.motion *
           (orbit.axis * (1.0 + 1.5 * d.eta2 + d.eEta * (4.0 + d.eta2)) +
            0.375 * kJ2 * d.xi / d.psi2 * tilt * (8.0 + 3.0 * d.eta2 * (8.0 + d.eta2)));
}

double c3(const MeanOrbit& orbit, const DragTerms& d)
{
    return -2.0 * d.strength * d.xi * (kJ3 / kJ2) * orbit.motion * orbit.sinInclination / orbit.eccentricity;
}

double c4(const MeanOrbit& orbit, const DragTerms& d)
{
    const double square = orbit.cosInclination * orbit.cosInclination;
    const double e = orbit.eccentricity;
    const double ofTilt = -3.0 * (3.0 * square - 1.0) * (1.0 - 2.0 * d.eEta + d.eta2 * (1.5 - 0.5 * d.eEta));
    const double ofPerigee =
        0.75 * (1.0 - square) * (2.0 * d.eta2 - d.eEta * (1.0 + d.eta2)) * std::cos(2.0 * orbit.perigee);
    return 2.0 * orbit.motion * d.density * orbit.parameter() *
           (d.eta * (2.0 + 0.5 * d.eta2) + e * (0.5 + 2.0 * d.eta2) -
            kJ2 * d.xi / (orbit.axis * d.psi2) * (ofTilt + ofPerigee));
}

double c5(const MeanOrbit& orbit, const DragTerms& d)
{
    return 2.0 * d.density * orbit.parameter() * (1.0 + 2.75 * (d.eta2 + d.eEta) + d.eEta * d.eta2);
}

}  // namespace

AirDrag::AirDrag(const MeanOrbit& orbit, const SecularRates& rates, bool isDeepSpace)
{
    const double height = (orbit.perigeeRadius() - 1.0) * kEarthRadius;
    const Atmosphere air = atmosphereAt(height);
    const DragTerms d(orbit, air);
    const double c1 = orbit.bstar * c2(orbit, d);
    m_simple = isDeepSpace || height < kFullDragHeight;
    m_axis1 = c1;
    m_eccentricity1 = orbit.bstar * c4(orbit, d);
    m_longitude2 = 1.5 * c1 * orbit.motion;
    m_node2 = 3.5 * orbit.roundness * rates.nodeByJ2 * c1;
    if (m_simple) {
        return;
    }
    m_axis2 = 4.0 * orbit.axis * d.xi * c1 * c1;
    const double third = m_axis2 * d.xi * c1 / 3.0;
    m_axis3 = (17.0 * orbit.axis + air.begins) * third;
    m_axis4 = 0.5 * third * orbit.axis * d.xi * (221.0 * orbit.axis + 31.0 * air.begins) * c1;
    m_longitude3 = (m_axis2 + 2.0 * c1 * c1) * orbit.motion;
    m_longitude4 = 0.25 * (3.0 * m_axis3 + c1 * (12.0 * m_axis2 + 10.0 * c1 * c1)) * orbit.motion;
    m_longitude5 =
        0.2 * orbit.motion *
        (3.0 * m_axis4 + 12.0 * c1 * m_axis3 + 6.0 * m_axis2 * m_axis2 + 15.0 * c1 * c1 * (2.0 * m_axis2 + c1 * c1));
    m_eccentricityBySine = orbit.bstar * c5(orbit, d);
    m_eta = d.eta;
    m_cubeAtEpoch = cubed(1.0 + d.eta * std::cos(orbit.anomaly));
    m_sineAtEpoch = std::sin(orbit.anomaly);
    if (orbit.eccentricity > kLeastEccentricity) {
        m_anomaly1 = orbit.bstar * c3(orbit, d) * std::cos(orbit.perigee);
        m_anomalyByCube = -2.0 / 3.0 * d.strength * orbit.bstar / d.eEta;
    }
}

AirDrag::Change AirDrag::after(double minutes, double anomaly) const
{
    const double square = minutes * minutes;
    Change change{.axisRoot = 1.0 - m_axis1 * minutes,
                  .eccentricity = m_eccentricity1 * minutes,
                  .longitude = m_longitude2 * square,
                  .node = m_node2 * square};
    if (!m_simple) {
        addHigherTerms(change, minutes, anomaly);
    }
    return change;
}

void AirDrag::addHigherTerms(Change& change, double minutes, double anomaly) const
{
    const double square = minutes * minutes;
    const Turn undragged = turnOf(anomaly);
    change.anomaly = m_anomaly1 * minutes + m_anomalyByCube * (cubed(1.0 + m_eta * undragged.cos) - m_cubeAtEpoch);
    change.axisRoot -= square * (m_axis2 + minutes * (m_axis3 + minutes * m_axis4));
    change.eccentricity += m_eccentricityBySine * (turnedBy(undragged, change.anomaly).sin - m_sineAtEpoch);
    change.longitude += square * minutes * (m_longitude3 + minutes * (m_longitude4 + minutes * m_longitude5));
}

}  // namespace boresight::orbit
