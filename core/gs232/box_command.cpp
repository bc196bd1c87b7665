// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232/box_command.h"

#include "core/base/upper.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace boresight::gs232 {
namespace {

std::optional<std::string> threeDigits(Angle angle, const TravelRange& reach)
{
    const double degrees = std::round(angle.degrees());
    if (!(degrees >= reach.min.degrees() && degrees <= reach.max.degrees())) {  // also false for NaN
        return std::nullopt;
    }
    const std::string digits = std::to_string(static_cast<int>(degrees));
    return std::string(3 - digits.size(), '0') + digits;
}

// 'd' in `form` means a digit.
bool hasForm(std::string_view line, std::string_view form)
{
    return std::ranges::equal(
        line, form, [](char one, char wanted) { return wanted == 'd' ? one >= '0' && one <= '9' : one == wanted; });
}

}  // namespace

std::optional<std::string> goTo(const AxisPosition& place)
{
    const auto azimuth = threeDigits(place.azimuth, kAzimuthReach);
    const auto elevation = threeDigits(place.elevation, kElevationReach);
    return azimuth && elevation ? std::optional("W" + *azimuth + " " + *elevation + "\r") : std::nullopt;
}

std::optional<std::string> goToAzimuth(Angle azimuth)
{
    const auto digits = threeDigits(azimuth, kAzimuthReach);
    return digits ? std::optional("M" + *digits + "\r") : std::nullopt;
}

// The first letter is the command. T begins to step through a list.
TypedEffect effectOfTyped(std::string_view line)
{
    const auto first = line.find_first_not_of(' ');
    const char letter = first == std::string_view::npos ? ' ' : upper(line[first]);
    if (std::string_view("MWRLUDT").find(letter) != std::string_view::npos) {
        return TypedEffect::Moves;
    }
    return letter == 'O' || letter == 'F' ? TypedEffect::AsksBack : TypedEffect::None;
}

bool isOwnCommand(std::string_view line)
{
    constexpr std::array<std::string_view, 5> kForms{"C2", "C", "S", "Wddd ddd", "Mddd"};
    return std::ranges::any_of(kForms, [line](std::string_view form) { return hasForm(line, form); });
}

}  // namespace boresight::gs232
