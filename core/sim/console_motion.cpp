// SPDX-License-Identifier: GPL-3.0-or-later
// The `d` commands.
#include "core/base/numbers.h"
#include "core/sim/console_commands.h"

namespace boresight::sim::console {
namespace {

using moteus::Mode;

// Applies one option: "p1.5" sets the kp scale to 1.5. False if the letter does not exist or is not permitted here.
bool applyOption(ServoCommand& command, std::string_view option, std::string_view permitted)
{
    const std::optional<double> number = option.substr(1) == "nan" ? kNone : parseFinite(option.substr(1));
    if (!number || permitted.find(option[0]) == std::string_view::npos) {
        return false;
    }
    switch (option[0]) {
        case 'p':
            command.kpScale = *number;
            break;
        case 'd':
            command.kdScale = *number;
            break;
        case 'i':
            command.integralLimitScale = *number;
            break;
        case 's':
            command.stopPosition = *number;
            break;
        case 'f':
            command.feedforwardTorque = *number;
            break;
        case 't':
            command.watchdogTimeout = *number;
            break;
        case 'v':
            command.velocityLimit = *number;
            break;
        case 'a':
            command.accelerationLimit = *number;
            break;
        case 'b':
            command.ignorePositionBounds = *number != 0.0;
            break;
        default:  // o, c: fixed voltage and current, which override the encoder. Accepted without effect
            break;
    }
    return true;
}

bool applyOptions(ServoCommand& command, std::string_view rest, std::string_view permitted)
{
    for (std::string_view option = takeWord(rest); !option.empty(); option = takeWord(rest)) {
        if (!applyOption(command, option, permitted)) {
            return false;
        }
    }
    return true;
}

std::string move(ConsoleDevice& device, std::string_view command, std::string_view rest)
{
    const std::optional<double> first = takeNumber(rest);
    const std::optional<double> second = takeNumber(rest);
    const std::optional<double> torque = takeNumber(rest);
    const bool within = command == "within";
    if (!first || !second || !torque) {
        return refusal(within ? "missing min/max/t" : "missing p/v/i");
    }
    ServoCommand asked{.mode = within ? Mode::StayWithin : Mode::Position, .watchdogTimeout = kNone};
    (within ? asked.stayWithinLower : asked.position) = *first;
    (within ? asked.stayWithinUpper : asked.velocity) = *second;
    asked.maximumTorque = *torque;
    if (!applyOptions(asked, rest, within ? "pditfb" : "pdisftavocb")) {
        return refusal("unknown option");
    }
    device.consoleCommand(asked);
    return std::string(kOk);
}

std::string setOutput(ConsoleDevice& device, std::string_view command, std::string_view rest)
{
    const double position = takeNumber(rest).value_or(0.0);
    if (command == "exact" || command == "index") {
        device.setOutputExact(position);
    } else if (command == "nearest" || command == "rezero") {
        device.setOutputNearest(position);
    } else if (command == "cfg-set-output") {
        device.configureOutput(position);
    } else if (command == "req-reindex") {
        device.requireReindex();
    } else if (command == "recapture") {
        device.recapture();
    } else {
        return refusal("unknown command");
    }
    return std::string(kOk);
}

}  // namespace

std::string motion(ConsoleDevice& device, std::string_view command, std::string_view rest)
{
    // Commands of the console have no watchdog, unless the line sets one.
    ServoCommand simple{.watchdogTimeout = kNone};
    if (command == "stop") {
        simple.mode = Mode::Stopped;
    } else if (command == "brake") {
        simple.mode = Mode::Brake;
    } else if (command == "zero") {
        simple.mode = Mode::ZeroVelocity;
    } else if (command == "tmt") {
        simple.mode = Mode::PositionTimeout;
    } else if (command == "pos" || command == "within") {
        return move(device, command, rest);
    } else {
        return setOutput(device, command, rest);
    }
    device.consoleCommand(simple);
    return std::string(kOk);
}

}  // namespace boresight::sim::console
