// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotator_box/spared_alarm.h"

#include "core/alarms/catalogue.h"
#include "core/units/degrees_text.h"

namespace boresight {

void SparedAlarm::look(const Seen& seen, const SwitchedMotors& motors, const profile::RotatorSettings& settings,
                       SteadyTime now)
{
    constexpr std::chrono::minutes kOver{1};
    const AlarmKey spared = alarmEntry("rotator.spared").of(seen.axis);
    const tracking::Leeway& leeway = motors.leeway(seen.axis);
    if (motors.axis(seen.axis).spared() && leeway.follows && seen.away > leeway.halfBeam) {
        m_late = now;
        m_alarms->raise(spared, {seen.label, degreesText(seen.away, 0), QString::number(settings.mostStarts)});
    } else if (m_late && (!seen.follows || now - *m_late > kOver)) {
        m_late.reset();
        m_alarms->clear(spared);
    }
}

}  // namespace boresight
