// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"
#include "core/units/sky.h"

#include <array>
#include <optional>

// What a rotator can do: control asks no more of it, and the screen shows no more. Constant for the life of a driver.
// Plain values.
namespace boresight {

struct AxisCapabilities
{
    Angle step{};                          // its places are multiples of it: it reports and reaches nothing else
    Angle miss{};                          // it may end this far beyond a step from where it was sent
    std::optional<AngularRate> fastest{};  // empty: whatever the profile permits
    Seconds silence{0.0};                  // after this long without an answer it is reported
    bool watchdog = false;                 // it stops by itself when the orders end
};

struct Capabilities
{
    std::array<std::optional<AxisCapabilities>, 2> axes{AxisCapabilities{}, AxisCapabilities{}};  // empty: no such axis

    [[nodiscard]] bool has(Axis axis) const { return axes[index(axis)].has_value(); }
    // An axis that runs to where it is sent by itself may be far behind its set-point.
    [[nodiscard]] bool lags(Axis axis) const { return has(axis) && axes[index(axis)]->miss > Angle{}; }
    // A place of an axis that was reached can be this far from what was asked for.
    [[nodiscard]] Angle inexactness(Axis axis) const
    {
        return has(axis) ? 0.5 * axes[index(axis)]->step + axes[index(axis)]->miss : Angle{};
    }
};

}  // namespace boresight
