// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/guards/sun_watch.h"

#include <optional>

// Raises the alarms about the Sun: the beam is too near to it, or its position is unknown because the clock is doubted.
// A mount that stands still is not moved when the Sun comes into its beam. Station thread only.
namespace boresight {

class SunAlarms
{
public:
    explicit SunAlarms(AlarmBoard& alarms) : m_alarms(alarms) {}

    // Call once in a tick. `distance` is the angle between the Sun and the nearest beam, empty while unknown. `missing`
    // is the axis that the mount does not have.
    void update(const SunWatch& sun, const std::optional<Angle>& distance, std::optional<Axis> missing);

private:
    void updateClock(const SunWatch& sun);

    AlarmBoard& m_alarms;
};

}  // namespace boresight
