// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/elements/element_set.h"
#include "core/ephemeris/refraction.h"
#include "core/orbit/sgp4.h"
#include "core/orbit/topocentric.h"
#include "core/schedule/night_plan.h"
#include "core/schedule/night_report.h"

#include <optional>

// The pass that the schedule tracks, or waits for: where its satellite is, and how well the beam follows. Pure.
namespace boresight {

class TrackedPass
{
public:
    TrackedPass(const schedule::WatchedPass& pass, const orbit::ElementSet& elements, const Site& site, SteadyTime now);

    [[nodiscard]] const schedule::WatchedPass& pass() const { return m_pass; }
    [[nodiscard]] UtcTime ends() const { return m_pass.ends(); }
    // The criteria for the beam.
    struct Scale
    {
        Angle beamWidth;
        ephemeris::RefractionRule refraction = ephemeris::RefractionRule::ByKind;
    };
    struct Beam
    {
        std::optional<SkyPointing> direction;  // in this tick; empty: unknown
        bool isOnTarget = true;
    };
    // The parts of the pass that the antenna cannot see do not count.
    void look(const Beam& beam, UtcTime utc, SteadyTime now, const Scale& scale);
    [[nodiscard]] const schedule::PassTally& tally() const { return m_tally; }

private:
    schedule::WatchedPass m_pass;
    orbit::Sgp4 m_orbit;
    orbit::Observer m_observer;
    schedule::PassTally m_tally;
    SteadyTime m_last;
};

}  // namespace boresight
