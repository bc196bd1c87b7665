// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orbit/sgp4.h"

#include "core/orbit/earth_gravity.h"
#include "core/orbit/sidereal_time.h"
#include "core/orbit/turn.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace boresight::orbit {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kDeepSpacePeriod = 225.0;  // min
constexpr double kMostMinutes = 100.0 * 365.25 * kMinutesPerDay;
constexpr double kLeastMeanEccentricity = -0.001;
constexpr double kRound = 1e-6;  // a smaller mean eccentricity is replaced by this one

std::optional<OrbitFault> faultOf(const ElementSet& elements)
{
    const double e = elements.eccentricity;
    if (!(e >= 0.0 && e < 1.0)) {
        return OrbitFault::MeanEccentricity;
    }
    const double angles = elements.inclination.radians() + elements.ascendingNode.radians() +
                          elements.perigee.radians() + elements.meanAnomaly.radians();
    const bool isFinite = std::isfinite(elements.revolutionsPerDay + elements.bstar + angles + elements.epoch.day +
                                        elements.epoch.fraction);
    return elements.revolutionsPerDay > 0.0 && isFinite ? std::nullopt : std::optional(OrbitFault::MeanMotion);
}

bool isFinite(const OrbitState& state)
{
    return std::isfinite(dot(state.position, state.position) + dot(state.velocity, state.velocity));
}

// False: the mean eccentricity is no longer valid. The drag of the node is already included.
bool addDrag(MomentElements& mean, const AirDrag::Change& drag)
{
    mean.axis *= drag.axisRoot * drag.axisRoot;
    mean.eccentricity -= drag.eccentricity;
    if (!(mean.eccentricity >= kLeastMeanEccentricity && mean.eccentricity < 1.0)) {
        return false;
    }
    mean.eccentricity = std::max(mean.eccentricity, kRound);
    mean.perigee -= drag.anomaly;
    mean.anomaly += drag.anomaly + drag.longitude;
    return true;
}

// The mean elements in deep space, with the periodics of Sun and Moon.
struct PerturbedElements
{
    MomentElements elements;
    double inclination = 0.0;
};

// Near the equator node and perigee are ill-defined, so their periodics are applied to the pole of the orbit (Lyddane).
// The perturbed inclination decides which way is used. Here the number of turns of the node matters.
void shiftByPole(PerturbedElements& orbit, const ThirdBody::Shifts& shifts, const Turn& inclination)
{
    const Turn node = turnOf(orbit.elements.node);
    const double x =
        inclination.sin * node.sin + shifts.nodeTimesSine * node.cos + shifts.inclination * inclination.cos * node.sin;
    const double y =
        inclination.sin * node.cos - shifts.nodeTimesSine * node.sin + shifts.inclination * inclination.cos * node.cos;
    const double before = std::fmod(orbit.elements.node, 2.0 * kPi);
    const double after = before + std::remainder(std::atan2(x, y) - before, 2.0 * kPi);
    orbit.elements.perigee +=
        shifts.perigeePlusNode - shifts.inclination * before * inclination.sin + inclination.cos * (before - after);
    orbit.elements.node = after;
    orbit.elements.anomaly += shifts.anomaly;
}

void shift(PerturbedElements& orbit, const ThirdBody::Shifts& shifts)
{
    constexpr double kLyddane = 0.2;  // rad
    orbit.inclination += shifts.inclination;
    orbit.elements.eccentricity += shifts.eccentricity;
    const Turn inclination = turnOf(orbit.inclination);
    if (orbit.inclination >= kLyddane) {
        const double node = shifts.nodeTimesSine / inclination.sin;
        orbit.elements.node += node;
        orbit.elements.perigee += shifts.perigeePlusNode - inclination.cos * node;
        orbit.elements.anomaly += shifts.anomaly;
    } else {
        shiftByPole(orbit, shifts, inclination);
    }
    if (orbit.inclination < 0.0) {
        orbit.inclination = -orbit.inclination;
        orbit.elements.node += kPi;
        orbit.elements.perigee -= kPi;
    }
}

}  // namespace

Sgp4::DeepSpace::DeepSpace(const MeanOrbit& orbit, const SecularRates& oblateness, const JulianDate& epoch)
    : sun(orbit, sunOrbit(epoch)), moon(orbit, moonOrbit(epoch))
{
    const ThirdBody::Rates& a = sun.rates();
    const ThirdBody::Rates& b = moon.rates();
    rates = {.eccentricity = a.eccentricity + b.eccentricity,
             .inclination = a.inclination + b.inclination,
             .anomaly = a.anomaly + b.anomaly,
             .perigee = a.perigee + b.perigee,
             .node = a.node + b.node};
    resonance = Resonance::of(orbit,
                              {.anomaly = oblateness.anomaly + rates.anomaly,
                               .perigee = oblateness.perigee + rates.perigee,
                               .node = oblateness.node + rates.node,
                               .perigeeByEarth = oblateness.perigee},
                              siderealTime(epoch));
}

Sgp4::Sgp4(const ElementSet& elements)
    : m_epoch(elements.epoch),
      m_orbit(meanOrbitOf(elements)),
      m_rates(secularRates(m_orbit)),
      m_drag(m_orbit, m_rates, periodMinutes() >= kDeepSpacePeriod),
      m_tilt({m_orbit.sinInclination, m_orbit.cosInclination}),
      m_fault(faultOf(elements))
{
    if (!m_fault && periodMinutes() >= kDeepSpacePeriod) {
        // The published values were computed with the epoch in one double, which is 20 µs off. The difference is
        // visible in the last digit of the effect of the Moon.
        m_deep.emplace(m_orbit, m_rates, JulianDate{.day = m_epoch.day + m_epoch.fraction});
    }
}

double Sgp4::periodMinutes() const
{
    return 2.0 * kPi / m_orbit.motion;
}

OrbitResult Sgp4::propagate(double minutes) const
{
    ResonanceState state;
    return propagate(minutes, state);
}

OrbitResult Sgp4::propagate(double minutes, ResonanceState& state) const
{
    if (m_fault) {
        return tl::unexpected(*m_fault);
    }
    if (!(std::abs(minutes) <= kMostMinutes)) {
        return tl::unexpected(OrbitFault::TooFarFromEpoch);
    }
    const OrbitResult result = m_deep ? deepSpace(minutes, state) : nearEarth(minutes);
    return !result || isFinite(*result) ? result : tl::unexpected(OrbitFault::MeanMotion);
}

OrbitResult Sgp4::propagate(const JulianDate& utc) const
{
    return propagate(minutesBetween(m_epoch, utc));
}

OrbitResult Sgp4::propagate(const JulianDate& utc, ResonanceState& state) const
{
    return propagate(minutesBetween(m_epoch, utc), state);
}

// The effect of the oblate Earth alone.
MomentElements Sgp4::secularElements(double minutes) const
{
    return {.axis = m_orbit.axis,
            .eccentricity = m_orbit.eccentricity,
            .node = m_orbit.node + m_rates.node * minutes,
            .perigee = m_orbit.perigee + m_rates.perigee * minutes,
            .anomaly = m_orbit.anomaly + m_rates.anomaly * minutes};
}

OrbitResult Sgp4::nearEarth(double minutes) const
{
    MomentElements mean = secularElements(minutes);
    const AirDrag::Change drag = m_drag.after(minutes, mean.anomaly);
    mean.node += drag.node;
    if (!addDrag(mean, drag)) {
        return tl::unexpected(OrbitFault::MeanEccentricity);
    }
    return osculatingState(mean, m_tilt);
}

OrbitResult Sgp4::deepSpace(double minutes, ResonanceState& state) const
{
    PerturbedElements orbit{.elements = secularElements(minutes), .inclination = m_orbit.inclination};
    MomentElements& mean = orbit.elements;
    const AirDrag::Change drag = m_drag.after(minutes, mean.anomaly);
    const ThirdBody::Rates& rates = m_deep->rates;
    mean.eccentricity += rates.eccentricity * minutes;
    orbit.inclination += rates.inclination * minutes;
    mean.perigee += rates.perigee * minutes;
    mean.node += drag.node + rates.node * minutes;
    mean.anomaly += rates.anomaly * minutes;
    if (m_deep->resonance) {
        const Resonance::Motion motion = m_deep->resonance->at(minutes, mean.node, mean.perigee, state);
        if (!(motion.motion > 0.0)) {
            return tl::unexpected(OrbitFault::MeanMotion);
        }
        mean.axis = std::pow(kSurfaceMotion / motion.motion, 2.0 / 3.0);
        mean.anomaly = motion.anomaly;
    }
    if (!addDrag(mean, drag)) {
        return tl::unexpected(OrbitFault::MeanEccentricity);
    }
    ThirdBody::Shifts shifts;
    m_deep->sun.addShifts(minutes, shifts);
    m_deep->moon.addShifts(minutes, shifts);
    shift(orbit, shifts);
    if (!(mean.eccentricity >= 0.0 && mean.eccentricity <= 1.0)) {
        return tl::unexpected(OrbitFault::PerturbedEccentricity);
    }
    return osculatingState(mean, Tilt(turnOf(orbit.inclination)));
}

}  // namespace boresight::orbit
