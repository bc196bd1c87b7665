// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/quantity.h"

#include <QString>

#include <chrono>

namespace boresight {

// How an axis stopped when it was really not fed any more.
struct CrashStop
{
    QString drive;                      // its UUID
    AngularRate rate;                   // at the last order
    Angle angle;                        // from there to standstill
    std::chrono::milliseconds time{0};  // from there to standstill
    UtcTime when;

    bool operator==(const CrashStop&) const = default;
};

}  // namespace boresight
