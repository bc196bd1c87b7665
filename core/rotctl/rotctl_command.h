// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

#include <optional>
#include <string>

// What a client says to a rotctld. The extended form is asked for with a "+": its answers name what they answer, and
// each ends in a line of its own. Servers that imitate rotctld often know the plain form only. Pure.
namespace boresight::rotctl {

enum class Form
{
    Extended,
    Plain
};

[[nodiscard]] std::string askState(Form form);  // the limits of the rotator
[[nodiscard]] std::string askPosition(Form form);
[[nodiscard]] std::string stopAll(Form form);
// With two decimals. Empty: an angle is no number, or no rotator turns that far.
[[nodiscard]] std::optional<std::string> goTo(Form form, const AxisPosition& place);

// Farther than any rotator turns.
inline constexpr TravelRange kPossibleAzimuth{.min = Angle::fromDegrees(-720.0), .max = Angle::fromDegrees(900.0)};
inline constexpr TravelRange kPossibleElevation{.min = Angle::fromDegrees(-180.0), .max = Angle::fromDegrees(360.0)};

}  // namespace boresight::rotctl
