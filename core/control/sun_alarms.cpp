// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/sun_alarms.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

namespace boresight {
namespace {

const QString kSunCause = QStringLiteral("Sun");
const QString kClockCause = QStringLiteral("Sun clock");
// A beam at the edge must not come and go with the noise of its encoder.
constexpr Angle kClear = Angle::fromDegrees(0.05);

}  // namespace

void SunAlarms::update(const SunWatch& sun, const std::optional<SkyPointing>& beam)
{
    updateClock(sun);
    const auto distance = beam ? sun.distance(*beam) : std::nullopt;
    if (!distance || *distance > sun.radius() + kClear) {
        m_alarms.clear(kSunCause);
    } else if (*distance < sun.radius() && !m_alarms.active(kSunCause)) {
        m_alarms.raise(
            kSunCause, Severity::Warning,
            {.what = Text::tr("The beam is less than %1° from the Sun")
                         .arg(toQString(formatFixed(sun.radius().degrees(), 1))),
             .action = Text::tr("Nothing moves by itself, and motions only lead out of there"),
             .remedy = Text::tr("Move the mount away, or let the Sun pass; sun.keep_away switches this off")});
    }
}

void SunAlarms::updateClock(const SunWatch& sun)
{
    if (!sun.clockDoubted()) {
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

}  // namespace boresight
