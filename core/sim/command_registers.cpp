// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/command_registers.h"

#include <algorithm>
#include <array>

namespace boresight::sim {
namespace {

using moteus::Register;

struct Entry
{
    Register reg;
    double ServoCommand::*field;
};

constexpr std::array<Entry, 23> kEntries{{
    {Register::QVoltage, &ServoCommand::qVoltage},
    {Register::CommandQCurrent, &ServoCommand::qCurrent},
    {Register::CommandDCurrent, &ServoCommand::dCurrent},
    {Register::CommandPosition, &ServoCommand::position},
    {Register::CommandVelocity, &ServoCommand::velocity},
    {Register::CommandFeedforwardTorque, &ServoCommand::feedforwardTorque},
    {Register::CommandKpScale, &ServoCommand::kpScale},
    {Register::CommandKdScale, &ServoCommand::kdScale},
    {Register::CommandMaximumTorque, &ServoCommand::maximumTorque},
    {Register::CommandStopPosition, &ServoCommand::stopPosition},
    {Register::CommandWatchdogTimeout, &ServoCommand::watchdogTimeout},
    {Register::CommandVelocityLimit, &ServoCommand::velocityLimit},
    {Register::CommandAccelerationLimit, &ServoCommand::accelerationLimit},
    {Register::CommandIntegralLimitScale, &ServoCommand::integralLimitScale},
    // A block that starts at 0x040 covers the whole stay-within command: these are the same fields again.
    {Register::StayWithinLower, &ServoCommand::stayWithinLower},
    {Register::StayWithinUpper, &ServoCommand::stayWithinUpper},
    {Register::StayWithinFeedforwardTorque, &ServoCommand::feedforwardTorque},
    {Register::StayWithinKpScale, &ServoCommand::kpScale},
    {Register::StayWithinKdScale, &ServoCommand::kdScale},
    {Register::StayWithinMaximumTorque, &ServoCommand::maximumTorque},
    {Register::StayWithinWatchdogTimeout, &ServoCommand::watchdogTimeout},
    {Register::StayWithinIntegralLimitScale, &ServoCommand::integralLimitScale},
    {Register::DVoltage, &ServoCommand::dVoltage},
}};

bool isIgnoreBounds(Register reg)
{
    return reg == Register::CommandIgnorePositionBounds || reg == Register::StayWithinIgnorePositionBounds;
}

}  // namespace

std::optional<double> readCommand(const ServoCommand& command, Register reg)
{
    if (isIgnoreBounds(reg)) {
        return command.ignorePositionBounds ? 1.0 : 0.0;
    }
    const auto* entry = std::ranges::find(kEntries, reg, &Entry::reg);
    return entry != kEntries.end() ? std::optional(command.*(entry->field)) : std::nullopt;
}

bool writeCommand(ServoCommand& command, Register reg, double value)
{
    if (isIgnoreBounds(reg)) {
        command.ignorePositionBounds = value != 0.0;
        return true;
    }
    const auto* entry = std::ranges::find(kEntries, reg, &Entry::reg);
    if (entry == kEntries.end()) {
        return false;
    }
    command.*(entry->field) = value;
    return true;
}

}  // namespace boresight::sim
