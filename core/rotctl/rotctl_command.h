// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

#include <optional>
#include <string>

// The commands of a client to a rotctld. A "+" asks for the extended form: its answers begin with the name of the
// command and end with a separate line. Servers that imitate rotctld often know only the plain form. Pure.
namespace boresight::rotctl {

enum class Form
{
    Extended,
    Plain
};

[[nodiscard]] std::string askState(Form form);  // the limits of the rotator
[[nodiscard]] std::string askPosition(Form form);
[[nodiscard]] std::string stopAll(Form form);
// The rotator drives to its own switches. Hamlib answers when it has passed the command on.
[[nodiscard]] std::string resetAll(Form form);
// With two decimals. Empty if an angle is not a number, or if no rotator turns that far.
[[nodiscard]] std::optional<std::string> goTo(Form form, const AxisPosition& place);

// Wider than the travel of any rotator.
inline constexpr TravelRange kPossibleAzimuth{.min = Angle::fromDegrees(-720.0), .max = Angle::fromDegrees(900.0)};
inline constexpr TravelRange kPossibleElevation{.min = Angle::fromDegrees(-180.0), .max = Angle::fromDegrees(360.0)};

}  // namespace boresight::rotctl
