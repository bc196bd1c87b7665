// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/quantity.h"

#include <QString>

#include <chrono>

namespace boresight {

// How an axis stopped in a crash-stop test, in which its drive really received no more commands.
struct CrashStop
{
    QString drive;                      // its UUID
    AngularRate rate;                   // at the last command
    Angle angle;                        // from the last command to standstill
    std::chrono::milliseconds time{0};  // from the last command to standstill
    UtcTime when;

    bool operator==(const CrashStop&) const = default;
};

}  // namespace boresight
