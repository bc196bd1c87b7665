// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/client_program.h"

#include <algorithm>

namespace boresight::rotctld {
namespace {

constexpr std::string_view kHamlib = "Hamlib network client";

std::size_t decimals(std::string_view number)
{
    const std::size_t point = number.find_first_of(".,");
    return point == std::string_view::npos ? 0 : number.size() - point - 1;
}

}  // namespace

void ClientProgram::observe(const Command& command)
{
    if (!m_name.empty()) {
        return;
    }
    const bool longName = command.spelling == Spelling::LongName;
    switch (command.spec->id) {
        case CommandId::GetPosition:
            m_askedPosition = true;
            break;
        case CommandId::DumpState:
            m_name = command.extended ? "CQRLOG" : kHamlib;
            break;
        case CommandId::GetInfo:
            m_name = command.extended && longName ? "HamClock" : "";
            break;
        case CommandId::SetPosition:
            m_name = byPointing(command);
            break;
        default:
            break;
    }
}

// The formats: Gpredict, SatDump, predict and flyby print %.2f, Hamlib %f, radiosonde_auto_rx %.1f, SatNOGS all
// digits of a Python float, SDRangel %g.
std::string_view ClientProgram::byPointing(const Command& command) const
{
    if (command.spelling == Spelling::BareName) {
        return "Look4Sat";
    }
    if (command.extended) {
        return command.separator == '|' ? "shell script" : "";
    }
    if (command.spelling == Spelling::LongName) {
        return "Look4Sat";
    }
    const std::size_t azimuth = decimals(command.arguments[0]);
    const std::size_t elevation = decimals(command.arguments[1]);
    if (std::max(azimuth, elevation) > 6) {
        return "SatNOGS client";
    }
    if (azimuth != elevation) {
        return azimuth > 2 || elevation > 2 ? "SDRangel" : "";
    }
    switch (azimuth) {
        case 1:
            return "radiosonde_auto_rx";
        case 2:
            return m_askedPosition ? "Gpredict or SatDump" : "predict or flyby";
        case 6:
            return kHamlib;
        default:
            return "";
    }
}

}  // namespace boresight::rotctld
