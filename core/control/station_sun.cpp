// SPDX-License-Identifier: GPL-3.0-or-later
// The part of StationControl that keeps the beam away from the Sun. It is a keep-out that is renewed as the Sun moves,
// so everything that obeys the region obeys it. A mount that stands while the Sun comes over it stays: it is told.
// While the clock is doubted it is a band across the sky, the places that the Sun can have.
#include "core/base/text.h"
#include "core/control/station_control.h"

namespace boresight {

// When the clock comes to be trusted, what was held back by the band stays where it is; when it comes to be doubted, a
// motion that is inside the band ends there.
void StationControl::renewSun(bool redrawn)
{
    const bool before = m_sun.clockDoubted();
    const bool heldBack = m_motion.limited() || !m_motion.noWay().empty() || m_motion.held(Axis::Azimuth) ||
                          m_motion.held(Axis::Elevation);
    if (m_sun.update(m_clock) || redrawn) {
        enforceRegion();
    }
    const bool doubted = m_sun.clockDoubted();
    if (doubted != before && moves() && (doubted ? gates().isInSunBand(m_motion.place()) : heldBack)) {
        m_log.add(Severity::Warning, QStringLiteral("station"),
                  Text::tr("ends the motion: %1")
                      .arg(doubted ? Text::tr("the clock of this computer is not synchronised")
                                   : Text::tr("the place of the Sun is known again")));
        holdHere(Activity::Holding);
    }
}

void StationControl::watchSun()
{
    renewSun(false);
    const auto measured = m_mount.measured();
    m_sunAlarms.update(m_sun, measured && turnsKnown() ? std::optional(m_model.toSky(*measured)) : std::nullopt);
}

}  // namespace boresight
