// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/elements/element_set.h"

// The expected error of elements by their age: the satellite is early or late on its orbit. A rule of thumb for an
// orbit without manoeuvres. Pure.
namespace boresight::orbit {

struct AgeError
{
    double kilometres = 0.0;  // along the orbit
    Seconds time{};           // in which the satellite moves this far
};

// Valid before and after the epoch.
[[nodiscard]] AgeError expectedError(const ElementSet& elements, UtcTime at);

}  // namespace boresight::orbit
