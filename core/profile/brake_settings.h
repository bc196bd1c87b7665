// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <string>

// The brakes of the axes, which one output releases. Plain values.
namespace boresight::profile {

struct BrakeSettings
{
    std::string output;      // "rts:/dev/ttyUSB0", see contacts/output_name.h; empty: none
    Seconds switching{0.5};  // the time that the brakes need to open or to close
    Seconds setAfter{10.0};  // without motion

    [[nodiscard]] bool isUsed() const { return !output.empty(); }
    bool operator==(const BrakeSettings&) const = default;
};

}  // namespace boresight::profile
