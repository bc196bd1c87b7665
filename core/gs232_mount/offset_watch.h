// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/gs232/esp32_offsets.h"
#include "core/profile/in_force.h"

#include <optional>

// Compares the sensor offsets that the box reports with those that the operator saved in the profile, and raises the
// alarm. Boresight cannot write them to the box. Station thread only.
namespace boresight::gs232 {

class OffsetWatch
{
public:
    // The references outlive this.
    OffsetWatch(const profile::InForce& profile, AlarmBoard& alarms) : m_profile(profile), m_alarms(alarms) {}

    // In each tick. Empty: not known, so an alarm stays as it is.
    void compare(const std::optional<esp32::Offsets>& reported);

private:
    const profile::InForce& m_profile;
    AlarmBoard& m_alarms;
};

}  // namespace boresight::gs232
