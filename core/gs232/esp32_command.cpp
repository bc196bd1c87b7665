// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232/esp32_command.h"

#include "core/base/numbers.h"
#include "core/base/upper.h"

#include <algorithm>

namespace boresight::gs232::esp32 {

// "AZ" and "EL" alone are questions, and so is "AZ-10".
bool movesWhenTyped(std::string_view line)
{
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    line = line.substr(0, line.find_last_not_of(' ') + 1);
    const bool isAxis = line.starts_with("AZ") || line.starts_with("EL");
    const bool hasTarget = line.size() > 2 && (line[2] == ' ' || (line[2] >= '0' && line[2] <= '9'));
    const std::string word = upper(line);
    return (isAxis && hasTarget) || word == "HOME" || word == "DANCE";
}

std::string goTo(Axis axis, Angle angle)
{
    const bool isAzimuth = axis == Axis::Azimuth;
    const Angle sent = isAzimuth ? angle.wrapped360() : angle;
    return (isAzimuth ? "AZ " : "EL ") + formatFixed(sent.degrees(), 1) + "\r";
}

}  // namespace boresight::gs232::esp32
