// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/stale_wait.h"

#include "core/base/time_of_day.h"

namespace boresight::sources {

bool StaleWait::isTooLong(const QString& why, SteadyTime now)
{
    if (!m_since) {
        m_since = now;
        m_helm.raiseAlarm(m_alarm, {why, timeOfDayText(m_helm.view().clock.utc() + kLongest)});
    }
    return now - *m_since >= kLongest;
}

void StaleWait::end()
{
    m_since.reset();
    m_helm.clearAlarm(m_alarm);
}

}  // namespace boresight::sources
