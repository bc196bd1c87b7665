// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/base/clock.h"
#include "core/profile/profile.h"
#include "core/rotator_box/switched_motors.h"
#include "core/units/sky.h"

#include <QString>

#include <optional>

// The alarm about an axis that the limit of motor starts keeps farther from its target than half the beam. It stays
// until the limit was no hindrance for a minute. Station thread only.
namespace boresight {

class SparedAlarm
{
public:
    struct Seen
    {
        Axis axis;
        QString label;
        Angle away;  // from its target
        bool follows = false;
    };

    // The board outlives this.
    explicit SparedAlarm(AlarmBoard& alarms) : m_alarms(&alarms) {}

    void look(const Seen& seen, const SwitchedMotors& motors, const profile::RotatorSettings& settings, SteadyTime now);

private:
    AlarmBoard* m_alarms;
    std::optional<SteadyTime> m_late;  // when the limit was last a hindrance
};

}  // namespace boresight
