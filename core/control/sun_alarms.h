// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/control/sun_watch.h"

#include <optional>

// Raises the alarms about the Sun: the beam stands too near to it, or no clock gives its position. A mount that stands
// while the Sun comes over it is left standing. Station thread only.
namespace boresight {

class SunAlarms
{
public:
    explicit SunAlarms(AlarmBoard& alarms) : m_alarms(alarms) {}

    // Once in a tick; `distance` is that of the nearest beam, empty while nobody knows it; `missing` is the axis that
    // the mount lacks.
    void update(const SunWatch& sun, const std::optional<Angle>& distance, std::optional<Axis> missing);

private:
    void updateClock(const SunWatch& sun);

    AlarmBoard& m_alarms;
};

}  // namespace boresight
