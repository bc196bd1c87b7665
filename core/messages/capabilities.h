// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"
#include "core/units/sky.h"

#include <array>
#include <optional>

// The capabilities of a rotator. Control requests nothing else, and the screen offers nothing else. Constant for the
// life of a driver. Plain values.
namespace boresight {

struct AxisCapabilities
{
    // A target may be this far from the step at which the axis stands: more than half a step, because an axis does not
    // turn back for less.
    static constexpr double kMostOfAStep = 0.75;

    Angle step{};                          // the axis reports and reaches only multiples of this angle
    Angle miss{};                          // the axis may stop this far from its target, beyond the rounding to a step
    std::optional<AngularRate> fastest{};  // empty: limited by the profile only
    Seconds silence{0.0};                  // without an answer for this time, an alarm is raised
    bool watchdog = false;                 // the axis stops by itself when no more commands arrive
    bool rareStarts = false;               // the motor is only switched on and off, and has to start seldom
};

struct Capabilities
{
    std::array<std::optional<AxisCapabilities>, 2> axes{AxisCapabilities{}, AxisCapabilities{}};  // empty: no such axis

    bool makesHomeRuns = false;  // it drives to its own switches by a command, and counts from there again

    [[nodiscard]] bool has(Axis axis) const { return axes[index(axis)].has_value(); }
    // An axis that runs to its target by itself may be far behind its set-point.
    [[nodiscard]] bool lags(Axis axis) const { return has(axis) && axes[index(axis)]->miss > Angle{}; }
    [[nodiscard]] bool hasSteps(Axis axis) const { return has(axis) && axes[index(axis)]->step > Angle{}; }
    [[nodiscard]] bool startsSeldom(Axis axis) const { return has(axis) && axes[index(axis)]->rareStarts; }
    // The largest distance between the place that an axis has reached and the place that was requested.
    [[nodiscard]] Angle inexactness(Axis axis) const
    {
        return has(axis) ? AxisCapabilities::kMostOfAStep * axes[index(axis)]->step + axes[index(axis)]->miss : Angle{};
    }
};

}  // namespace boresight
