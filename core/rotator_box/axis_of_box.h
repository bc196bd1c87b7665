// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/capabilities.h"
#include "core/rotator_box/each_step.h"
#include "core/rotator_box/obedience_watch.h"
#include "core/rotator_box/place_filter.h"
#include "core/rotator_box/spared_alarm.h"
#include "core/tracking/axis_setpoints.h"
#include "core/units/sky.h"

#include <algorithm>
#include <array>
#include <optional>

// What BoxMount knows of one axis of a rotator, and of the rotator. Plain values.
namespace boresight {

struct AxisOfBox
{
    ObedienceWatch watch;
    SparedAlarm spared;
    PlaceFilter filter{};
    std::optional<PlaceFilter::Jump> jump{};  // not yet reported
    tracking::Setpoint setpoint{};
    EachStep each{};      // without rare starts
    bool begins = false;  // starts to follow, but takeFollowing() was not called yet
};

struct StateOfBox
{
    bool wanted = false;  // engage() was called, and the axes do not follow yet
    bool follows = false;
    bool lost = false;    // nothing moves before recover()
    bool silent = false;  // it answered before, but does not answer any more
    bool hard = false;    // hard braking, after STOP
};

// Empty: the rotator does not turn this axis.
[[nodiscard]] inline std::optional<AxisCapabilities> capabilitiesOf(const AxisSet& axes, Axis axis,
                                                                    const std::array<AxisCapabilities, 2>& each)
{
    return std::ranges::find(axes, axis) != axes.end() ? std::optional(each[index(axis)]) : std::nullopt;
}

}  // namespace boresight
