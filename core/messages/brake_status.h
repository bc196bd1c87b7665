// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/brake/brake_sequence.h"

#include <QString>

// The brakes of the axes. One output releases them before a motion and sets them after it.
namespace boresight {

struct BrakeStatus
{
    QString output;  // its name in the profile; empty: there is no brake
    brake::BrakeState state = brake::BrakeState::Setting;
    QString problem;  // of the output; empty: none
};

}  // namespace boresight
