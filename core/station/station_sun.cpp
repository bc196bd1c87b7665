// SPDX-License-Identifier: GPL-3.0-or-later
// The part of StationControl that keeps the beam away from the Sun. It is a keep-out that is renewed as the Sun moves,
// so everything that obeys the region obeys it. A mount that stands while the Sun comes over it stays: it is told.
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/station/station_control.h"

namespace boresight {
namespace {

const QString kCause = QStringLiteral("Sun");
// A beam at the edge must not come and go with the noise of its encoder.
constexpr Angle kClear = Angle::fromDegrees(0.05);

}  // namespace

void StationControl::watchSun()
{
    if (m_sun.update(m_clock.utc())) {
        enforceRegion();
    }
    const auto measured = m_drives.measured();
    const auto distance = measured && turnsKnown() ? m_sun.distance(m_model.toSky(*measured)) : std::nullopt;
    if (distance && *distance < m_sun.radius()) {
        tellSun();
    } else if (!distance || *distance > m_sun.radius() + kClear) {
        m_alarms.clear(kCause);
    }
}

void StationControl::tellSun()
{
    if (m_alarms.active(kCause)) {
        return;
    }
    m_alarms.raise(kCause, Severity::Warning,
                   {.what = Text::tr("The beam is less than %1° from the Sun")
                                .arg(toQString(formatFixed(m_sun.radius().degrees(), 1))),
                    .action = Text::tr("Nothing moves by itself, and motions only lead out of there"),
                    .remedy = Text::tr("Move the mount away, or let the Sun pass; sun.keep_away switches this off")});
}

}  // namespace boresight
