// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"

#include <QString>

// Raises an alarm while the mount goes to the nearest permitted place instead of the target. The rotctld protocol has
// no answer for this case: the client receives "done". Station thread only.
namespace boresight {

class TargetAlarm
{
public:
    explicit TargetAlarm(AlarmBoard& alarms) : m_alarms(alarms) {}

    // Call once in a tick. `limitedReason` is empty while the mount goes to the target itself.
    void update(const QString& limitedReason);

private:
    AlarmBoard& m_alarms;
};

}  // namespace boresight
