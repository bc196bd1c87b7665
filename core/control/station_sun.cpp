// SPDX-License-Identifier: GPL-3.0-or-later
// The part of StationControl that keeps the beam away from the Sun. It is a keep-out that is renewed as the Sun moves,
// so everything that obeys the region obeys it. A mount that stands while the Sun comes over it stays: it is told.
// While the clock is doubted it is a band across the sky, the places that the Sun can have.
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/control/station_control.h"

#include <algorithm>

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
    if (doubted != before && moves() && (doubted ? isInSunBand(m_motion.place()) : heldBack)) {
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
    const auto measured = m_drives.measured();
    m_sunAlarms.update(m_sun, measured && turnsKnown() ? std::optional(m_model.toSky(*measured)) : std::nullopt);
}

bool StationControl::isInSunBand(const AxisPosition& place) const
{
    return turnsKnown() && m_sun.mayBeAt(m_model.toSky(place));
}

// Nobody knows where in the band the Sun is, so that no way out of it is known to be a safe one.
Result<> StationControl::mayLeaveSunBand(const AxisRates& rates, const Source& source) const
{
    const AngularRate fastest = m_profile.jog.unwind;
    const AngularRate rate = std::max(abs(rates.azimuth), abs(rates.elevation));
    const bool jogsSlowly = source.kind == SourceKind::Operator && rate > AngularRate{} && rate <= fastest;
    if (jogsSlowly || !isInSunBand(standing())) {
        return {};
    }
    return failure(ErrorCode::Refused,
                   Text::tr("the clock of this computer is not synchronised, so the Sun may be in the beam: only the "
                            "operator may jog the mount out of there, at %1°/s or slower")
                       .arg(toQString(formatFixed(fastest.degrees(), 1))));
}

}  // namespace boresight
