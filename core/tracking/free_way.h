// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

// Where both axes may go from their set-points, each at its own pace: all that lies between is permitted. For a rotator
// that drives to a place by itself. Mechanical angles. Plain value.
namespace boresight::tracking {

struct FreeWay
{
    AxisPosition end;    // of the way; of what is followed: where it is now
    AxisPosition ahead;  // where what is followed will be soon; the same place if it stands

    [[nodiscard]] bool stands() const { return end == ahead; }
    bool operator==(const FreeWay&) const = default;
};

}  // namespace boresight::tracking
