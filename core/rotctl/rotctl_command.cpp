// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctl/rotctl_command.h"

#include "core/base/numbers.h"

namespace boresight::rotctl {

std::string askState(Form form)
{
    return form == Form::Extended ? "+\\dump_state\n" : "\\dump_state\n";
}

std::string askPosition(Form form)
{
    return form == Form::Extended ? "+\\get_pos\n" : "p\n";
}

std::string stopAll(Form form)
{
    return form == Form::Extended ? "+\\stop\n" : "S\n";
}

std::string resetAll(Form form)
{
    return form == Form::Extended ? "+\\reset 1\n" : "R 1\n";
}

std::optional<std::string> goTo(Form form, const AxisPosition& place)
{
    if (!kPossibleAzimuth.contains(place.azimuth) || !kPossibleElevation.contains(place.elevation)) {
        return std::nullopt;  // also if an angle is not a number
    }
    return (form == Form::Extended ? "+\\set_pos " : "P ") + formatFixed(place.azimuth.degrees(), 2) + " " +
           formatFixed(place.elevation.degrees(), 2) + "\n";
}

}  // namespace boresight::rotctl
