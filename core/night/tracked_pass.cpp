// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/night/tracked_pass.h"

#include "core/elements/julian_date.h"
#include "core/targets/target_path.h"
#include "core/units/angle_between.h"

namespace boresight {

TrackedPass::TrackedPass(const schedule::WatchedPass& pass, const orbit::ElementSet& elements, const Site& site,
                         SteadyTime now)
    : m_pass(pass),
      m_orbit(elements),
      m_observer(site),
      m_tally({.number = pass.number, .name = pass.name, .aos = pass.rises(), .los = pass.sets(), .why = {}}),
      m_last(now)
{}

void TrackedPass::look(const Beam& beam, UtcTime utc, SteadyTime now, const Scale& scale)
{
    const Seconds during = now - m_last;
    m_last = now;
    if (!beam.direction || !m_pass.pass.isClearAt(utc)) {
        return;
    }
    const orbit::JulianDate date = orbit::julianDate(utc);
    if (const orbit::OrbitResult state = m_orbit.propagate(date)) {
        const SkyPointing satellite =
            targets::satelliteSeen(m_observer.look(orbit::groundState(*state, date)).direction, scale.refraction);
        m_tally.add(
            {.error = angleBetween(*beam.direction, satellite), .isOnTarget = beam.isOnTarget, .during = during},
            scale.beamWidth);
    }
}

}  // namespace boresight
