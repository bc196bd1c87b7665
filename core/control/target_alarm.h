// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"

#include <QString>

// Raises an alarm for as long as not the target is driven but the nearest permitted place. The rotctld protocol has no
// answer for that: the client receives "done". Station thread only.
namespace boresight {

class TargetAlarm
{
public:
    explicit TargetAlarm(AlarmBoard& alarms) : m_alarms(alarms) {}

    // Once in a tick. `limitedReason` is empty while the target itself is driven.
    void update(const QString& limitedReason);

private:
    AlarmBoard& m_alarms;
};

}  // namespace boresight
