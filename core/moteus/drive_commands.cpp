// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/drive_commands.h"

#include "core/base/overloaded.h"

#include <numbers>

namespace boresight::moteus {
namespace {

class WriteList
{
public:
    WriteList() { m_writes.reserve(kLongest); }
    explicit WriteList(Mode mode) : WriteList()
    {
        m_writes.push_back({Register::Mode, Resolution::Int8, static_cast<double>(mode)});
    }

    WriteList&& with(Register reg, const std::optional<Field>& field) &&
    {
        if (field) {
            m_writes.push_back({reg, field->resolution, field->value});
        }
        return std::move(*this);
    }

    // The registers of these angles count half turns.
    WriteList&& withHalfTurns(Register reg, const std::optional<Field>& field) &&
    {
        if (field) {
            m_writes.push_back({reg, field->resolution, field->value / std::numbers::pi});
        }
        return std::move(*this);
    }

    [[nodiscard]] std::vector<RegisterValue> take() && { return std::move(m_writes); }

private:
    static constexpr std::size_t kLongest = 17;  // a PositionCommand

    std::vector<RegisterValue> m_writes;
};

// Any value written to these registers triggers them.
constexpr Field kTrigger{1.0, Resolution::Int8};

Register outputsOf(int port)
{
    return static_cast<Register>(static_cast<std::uint32_t>(Register::AuxGpioCommand) +
                                 static_cast<std::uint32_t>(port - 1));
}

WriteList listOf(const PositionCommand& c)
{
    return WriteList(Mode::Position)
        .with(Register::CommandPosition, c.position)
        .with(Register::CommandVelocity, c.velocity)
        .with(Register::CommandFeedforwardTorque, c.feedforwardTorque)
        .with(Register::CommandKpScale, c.kpScale)
        .with(Register::CommandKdScale, c.kdScale)
        .with(Register::CommandMaximumTorque, c.maximumTorque)
        .with(Register::CommandStopPosition, c.stopPosition)
        .with(Register::CommandWatchdogTimeout, c.watchdogTimeout)
        .with(Register::CommandVelocityLimit, c.velocityLimit)
        .with(Register::CommandAccelerationLimit, c.accelerationLimit)
        .with(Register::CommandFixedVoltage, c.fixedVoltage)
        .with(Register::CommandIntegralLimitScale, c.integralLimitScale)
        .with(Register::CommandFixedCurrent, c.fixedCurrent)
        .with(Register::CommandIgnorePositionBounds, c.ignorePositionBounds)
        .with(Register::StayWithinLower, c.echo)
        .with(Register::RecapturePositionVelocity, c.recapture ? std::optional(kTrigger) : std::nullopt);
}

WriteList listOf(const StayWithin& c)
{
    return WriteList(Mode::StayWithin)
        .with(Register::StayWithinLower, c.lower)
        .with(Register::StayWithinUpper, c.upper)
        .with(Register::StayWithinFeedforwardTorque, c.feedforwardTorque)
        .with(Register::StayWithinKpScale, c.kpScale)
        .with(Register::StayWithinKdScale, c.kdScale)
        .with(Register::StayWithinMaximumTorque, c.maximumTorque)
        .with(Register::StayWithinWatchdogTimeout, c.watchdogTimeout)
        .with(Register::StayWithinIntegralLimitScale, c.integralLimitScale)
        .with(Register::StayWithinIgnorePositionBounds, c.ignorePositionBounds);
}

WriteList listOf(const PwmCommand& c)
{
    return WriteList(Mode::Pwm)
        .with(Register::PwmPhaseA, c.a)
        .with(Register::PwmPhaseB, c.b)
        .with(Register::PwmPhaseC, c.c);
}

WriteList listOf(const VoltageCommand& c)
{
    return WriteList(Mode::Voltage)
        .with(Register::VoltagePhaseA, c.a)
        .with(Register::VoltagePhaseB, c.b)
        .with(Register::VoltagePhaseC, c.c);
}

WriteList listOf(const VoltageFocCommand& c)
{
    return WriteList(Mode::VoltageFoc)
        .withHalfTurns(Register::VfocTheta, c.theta)
        .with(Register::VfocVoltage, c.voltage)
        .withHalfTurns(Register::VfocThetaRate, c.thetaRate);
}

}  // namespace

std::vector<RegisterValue> registerWrites(const Command& command)
{
    WriteList list = std::visit(
        Overloaded{
            [](const Stop&) { return WriteList(Mode::Stopped); },
            [](const Brake&) { return WriteList(Mode::Brake); },
            [](const ZeroVelocity& c) {
                return WriteList(Mode::ZeroVelocity).with(Register::CommandKdScale, c.kdScale);
            },
            [](const VoltageDqCommand& c) {
                return WriteList(Mode::VoltageDq).with(Register::DVoltage, c.d).with(Register::QVoltage, c.q);
            },
            [](const CurrentCommand& c) {
                return WriteList(Mode::Current)
                    .with(Register::CommandQCurrent, c.q)
                    .with(Register::CommandDCurrent, c.d);
            },
            [](const SetOutputNearest& c) { return WriteList().with(Register::SetOutputNearest, c.position); },
            [](const SetOutputExact& c) { return WriteList().with(Register::SetOutputExact, c.position); },
            [](const RequireReindex&) { return WriteList().with(Register::RequireReindex, kTrigger); },
            [](const RecapturePositionVelocity&) {
                return WriteList().with(Register::RecapturePositionVelocity, kTrigger);
            },
            [](const ClockTrim& c) { return WriteList().with(Register::ClockTrim, c.trim); },
            [](const SetOutputs& c) {
                return WriteList().with(outputsOf(c.port), Field{static_cast<double>(c.bits), Resolution::Int8});
            },
            [](const auto& c) { return listOf(c); },
        },
        command);
    return std::move(list).take();
}

}  // namespace boresight::moteus
