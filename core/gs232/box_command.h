// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

#include <optional>
#include <string>
#include <string_view>

// The commands to a GS-232A, a GS-232B or a box that imitates them. Whole degrees, always three digits. Every command
// ends with one CR: the second CR that some programs send is an empty command to the box. Pure.
namespace boresight::gs232 {

// The range of targets of such a box, in its own count: it passes north and continues to 450°. It flips over at the
// zenith.
inline constexpr TravelRange kAzimuthReach{.min = Angle::fromDegrees(0.0), .max = Angle::fromDegrees(450.0)};
inline constexpr TravelRange kElevationReach{.min = Angle::fromDegrees(0.0), .max = Angle::fromDegrees(180.0)};

inline constexpr std::string_view kAskBoth = "C2\r";
inline constexpr std::string_view kAskAzimuth = "C\r";  // also answered by a box without an elevation
inline constexpr std::string_view kStopAll = "S\r";

// Rounded to the nearest whole degree. Empty if the box cannot be sent there.
[[nodiscard]] std::optional<std::string> goTo(const AxisPosition& place);
// For a box without an elevation.
[[nodiscard]] std::optional<std::string> goToAzimuth(Angle azimuth);

// What a typed line would do besides being answered.
enum class TypedEffect
{
    None,
    Moves,    // it moves the rotator, at once or later
    AsksBack  // the box waits for the operator, and takes the next question for his answer
};
[[nodiscard]] TypedEffect effectOfTyped(std::string_view line);

// One of the commands above, without its line end. Such a line from the box is the echo of our own command.
[[nodiscard]] bool isOwnCommand(std::string_view line);

}  // namespace boresight::gs232
