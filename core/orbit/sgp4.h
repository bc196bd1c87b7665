// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/element_set.h"
#include "core/orbit/air_drag.h"
#include "core/orbit/mean_orbit.h"
#include "core/orbit/orbit_state.h"
#include "core/orbit/osculating.h"
#include "core/orbit/resonance.h"
#include "core/orbit/third_body.h"

#include <optional>

// SGP4, and SDP4 for periods from 225 min, as merged and corrected in AIAA 2006-6753 (Vallado, Crawford, Hujsak, Kelso:
// Revisiting Spacetrack Report 3), in its improved mode. An immutable value that threads may share. Never returns NaN.
namespace boresight::orbit {

class Sgp4
{
public:
    // Invalid elements (e outside [0, 1), mean motion not above 0, not finite) give a fault at every time.
    explicit Sgp4(const ElementSet& elements);

    // Minutes after the epoch; negative before it. For an orbit with resonance each call integrates from the epoch,
    // unless a state of this orbit is passed.
    [[nodiscard]] OrbitResult propagate(double minutes) const;
    [[nodiscard]] OrbitResult propagate(double minutes, ResonanceState& state) const;
    [[nodiscard]] OrbitResult propagate(const JulianDate& utc) const;
    [[nodiscard]] OrbitResult propagate(const JulianDate& utc, ResonanceState& state) const;

    [[nodiscard]] const JulianDate& epoch() const { return m_epoch; }
    [[nodiscard]] bool isDeepSpace() const { return m_deep.has_value(); }
    [[nodiscard]] double periodMinutes() const;

private:
    struct DeepSpace
    {
        DeepSpace(const MeanOrbit& orbit, const SecularRates& rates, const JulianDate& epoch);

        ThirdBody sun;
        ThirdBody moon;
        ThirdBody::Rates rates;  // of Sun and Moon together
        std::optional<Resonance> resonance;
    };

    [[nodiscard]] MomentElements secularElements(double minutes) const;
    [[nodiscard]] OrbitResult nearEarth(double minutes) const;
    [[nodiscard]] OrbitResult deepSpace(double minutes, ResonanceState& state) const;

    JulianDate m_epoch;
    MeanOrbit m_orbit;
    SecularRates m_rates;
    AirDrag m_drag;
    Tilt m_tilt;
    std::optional<DeepSpace> m_deep;
    std::optional<OrbitFault> m_fault;  // the elements are invalid
};

}  // namespace boresight::orbit
