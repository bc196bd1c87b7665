// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/elements/element_set.h"

// How wrong elements of some age have to be expected: the satellite comes early or late on its orbit. A rule of thumb,
// for an orbit without manoeuvres. Pure.
namespace boresight::orbit {

struct AgeError
{
    double kilometres = 0.0;  // along the orbit
    Seconds time{};           // that the satellite needs for them
};

// Before the epoch as after it.
[[nodiscard]] AgeError expectedError(const ElementSet& elements, UtcTime at);

}  // namespace boresight::orbit
