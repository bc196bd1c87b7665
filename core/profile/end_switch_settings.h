// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/numbers.h"
#include "core/end_switches/end_switch.h"
#include "core/units/quantity.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

// The inputs of the end switches. Plain values.
namespace boresight::profile {

// What an input reads while its switch is pressed. Off suits a switch that opens its circuit: a broken wire then counts
// as pressed.
enum class PressedWhen
{
    Off,
    On
};

enum class WhenUnread
{
    Pressed,
    Ignored
};

struct EndSwitchSettings
{
    // Each by end_switches::indexOf(), see contacts/input_name.h. Empty: there is no such switch.
    std::array<std::string, end_switches::kEndSwitches.size()> inputs;
    // Angle of the axis at which each switch is met, in degrees. Empty: not known, so it is not compared.
    std::array<std::string, end_switches::kEndSwitches.size()> places;
    Angle lostSteps = Angle::fromDegrees(3.0);  // an axis that meets its switch farther from that angle has lost steps
    PressedWhen pressedWhen = PressedWhen::Off;
    WhenUnread whenUnread = WhenUnread::Pressed;
    Seconds silence{5.0};  // a message that is older does not count

    [[nodiscard]] const std::string& input(const end_switches::EndSwitch& one) const
    {
        return inputs.at(end_switches::indexOf(one));
    }
    [[nodiscard]] std::optional<Angle> place(const end_switches::EndSwitch& one) const
    {
        const auto degrees = parseFinite(places.at(end_switches::indexOf(one)));
        return degrees ? std::optional(Angle::fromDegrees(*degrees)) : std::nullopt;
    }
    [[nodiscard]] bool isUsed() const
    {
        return std::ranges::any_of(inputs, [](const std::string& input) { return !input.empty(); });
    }
    bool operator==(const EndSwitchSettings&) const = default;
};

}  // namespace boresight::profile
