// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/guards/sun_alarms.h"

#include "core/alarms/catalogue.h"
#include "core/base/numbers.h"
#include "core/base/text.h"

namespace boresight {
namespace {

// The alarm clears only this far outside the radius. Encoder noise must not raise and clear it again and again.
constexpr Angle kClear = Angle::fromDegrees(0.05);

}  // namespace

void SunAlarms::update(const SunWatch& sun, const std::optional<Angle>& distance, std::optional<Axis> missing)
{
    updateClock(sun);
    if (!distance || *distance > sun.radius() + kClear) {
        m_alarms.clear(alarmEntry("sun.near"));
    } else if (*distance < sun.radius() && !m_alarms.active(alarmEntry("sun.near"))) {
        m_alarms.raise(missing ? alarmEntry("sun.near-one-axis") : alarmEntry("sun.near"),
                       {toQString(formatFixed(sun.radius().degrees(), 1))});
    }
}

void SunAlarms::updateClock(const SunWatch& sun)
{
    if (!sun.clockDoubted()) {
        m_alarms.clear(alarmEntry("sun.clock"));
    } else if (!m_alarms.active(alarmEntry("sun.clock"))) {
        m_alarms.raise(alarmEntry("sun.clock"));
    }
}

}  // namespace boresight
