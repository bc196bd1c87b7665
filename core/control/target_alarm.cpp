// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/target_alarm.h"

#include "core/alarms/catalogue.h"

namespace boresight {

void TargetAlarm::update(const QString& limitedReason)
{
    if (limitedReason.isEmpty()) {
        m_alarms.clear(alarmEntry("target.outside"));
        return;
    }
    m_alarms.raise(alarmEntry("target.outside"), {limitedReason});
}

}  // namespace boresight
