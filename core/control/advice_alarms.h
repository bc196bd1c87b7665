// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/messages/capabilities.h"
#include "core/profile/advice.h"
#include "core/profile/profile.h"

#include <vector>

// Raises the advice on the profile in force as alarms, and clears the advice that no longer applies. Also raises an
// alarm when a drive of the mount has no watchdog. Station thread only.
namespace boresight {

class AdviceAlarms
{
public:
    explicit AdviceAlarms(AlarmBoard& alarms) : m_alarms(alarms) {}

    void update(const profile::Profile& profile);
    void explain(const Capabilities& capabilities);

private:
    AlarmBoard& m_alarms;
    std::vector<profile::Advice> m_advice;  // that is raised now
};

}  // namespace boresight
