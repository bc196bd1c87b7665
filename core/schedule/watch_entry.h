// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <cstdint>

// The entries of the watch list, and the policy for passes that overlap. Pure values.
namespace boresight::schedule {

struct WatchEntry
{
    int number = 0;    // of the satellite in the catalogue
    int priority = 1;  // 1 is the most important
    Angle leastElevation = Angle::fromDegrees(10.0);

    bool operator==(const WatchEntry&) const = default;
};

// Which of two passes is tracked.
enum class OverlapPolicy
{
    Priority,  // the more important satellite
    Longest,   // the longer pass
    First      // the one that begins first
};

}  // namespace boresight::schedule
