// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/end_switches/end_switch.h"

#include <QString>

// An end switch that the profile names. Plain values.
namespace boresight {

struct EndSwitchStatus
{
    end_switches::EndSwitch which;
    QString input;  // its name in the profile
    end_switches::SwitchState state = end_switches::SwitchState::Unread;
    QString problem;        // why it cannot be read; empty: no problem is known
    bool isClosed = false;  // no motion into this end
};

}  // namespace boresight
