// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"

// Where the mount was when somebody looked at it, as entered on the command line. Mechanical angles. Plain value.
namespace boresight {

struct EnteredPlace
{
    AxisPosition place;
    UtcTime looked;

    bool operator==(const EnteredPlace&) const = default;
};

}  // namespace boresight
