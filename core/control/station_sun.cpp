// SPDX-License-Identifier: GPL-3.0-or-later
// The part of StationControl that keeps the beam away from the Sun. It is a keep-out that is renewed as the Sun moves,
// so everything that obeys the region obeys it. A mount that stands while the Sun comes over it stays: it is told.
// While the clock is doubted it is a band across the sky, the places that the Sun can have.
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/control/station_control.h"

#include <algorithm>

namespace boresight {
namespace {

const QString kSunCause = QStringLiteral("Sun");
const QString kClockCause = QStringLiteral("Sun clock");
// A beam at the edge must not come and go with the noise of its encoder.
constexpr Angle kClear = Angle::fromDegrees(0.05);

}  // namespace

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
    tellSunClock();
    const auto measured = m_drives.measured();
    const auto distance = measured && turnsKnown() ? m_sun.distance(m_model.toSky(*measured)) : std::nullopt;
    if (distance && *distance < m_sun.radius()) {
        tellSun();
    } else if (!distance || *distance > m_sun.radius() + kClear) {
        m_alarms.clear(kSunCause);
    }
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

void StationControl::tellSunClock()
{
    if (!m_sun.clockDoubted()) {
        m_alarms.clear(kClockCause);
    } else if (!m_alarms.active(kClockCause)) {
        m_alarms.raise(
            kClockCause, Severity::Warning,
            {.what = Text::tr("The clock of this computer is not synchronised, so the place of the Sun is unknown"),
             .action = Text::tr("Boresight refuses motions to every place that the Sun can have"),
             .remedy =
                 Text::tr("Synchronise the clock by NTP or GPS. If its time is right, set sun.clock to trusted")});
    }
}

void StationControl::tellSun()
{
    if (m_alarms.active(kSunCause)) {
        return;
    }
    m_alarms.raise(kSunCause, Severity::Warning,
                   {.what = Text::tr("The beam is less than %1° from the Sun")
                                .arg(toQString(formatFixed(m_sun.radius().degrees(), 1))),
                    .action = Text::tr("Nothing moves by itself, and motions only lead out of there"),
                    .remedy = Text::tr("Move the mount away, or let the Sun pass; sun.keep_away switches this off")});
}

}  // namespace boresight
