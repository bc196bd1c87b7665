// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/servo_control.h"

#include "core/moteus/faults.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace boresight::sim {
namespace {

using moteus::Mode;

constexpr double kServoPowerFactor = 1.5;  // three phases counted in peak values
constexpr double kBoardResistance = 0.01;  // Ω: transistors and shunts of one phase
constexpr double kIdlePower = 1.5;         // W: consumption of an idle board

// The device counts position in 2^-16 turns, and control velocity in 2^-32 turns per period of 1/30000 s. It truncates
// commands towards zero.
constexpr double kPositionSteps = 65536.0;
constexpr double kVelocitySteps = 65536.0 * 65536.0 / 30000.0;

double limitOr(double commanded, double configured)
{
    const double limit = std::isnan(commanded) ? configured : commanded;
    return std::isnan(limit) || limit < 0.0 ? std::numeric_limits<double>::infinity() : limit;
}

TrajectoryTarget targetOf(const ServoCommand& command)
{
    TrajectoryTarget target;
    if (std::isfinite(command.position)) {
        target.position = std::trunc(command.position * kPositionSteps) / kPositionSteps;
    }
    if (std::isfinite(command.velocity)) {
        target.velocity = std::trunc(command.velocity * kVelocitySteps) / kVelocitySteps;
    }
    return target;
}

}  // namespace

bool controlsPosition(Mode mode)
{
    return mode == Mode::Position || mode == Mode::PositionTimeout || mode == Mode::ZeroVelocity ||
           mode == Mode::StayWithin;
}

void ServoControl::capture(const ServoInputs& inputs)
{
    const bool moving = std::abs(inputs.velocity) > m_config.servo.velocityZeroCaptureThreshold;
    m_planner.capture(inputs.position, moving ? inputs.velocity : 0.0);
}

void ServoControl::setTarget(const ServoCommand& command, double age)
{
    m_planner.setTarget(targetOf(command), age);
}

TrajectoryLimits ServoControl::limits(const ServoCommand& command, double busVoltage) const
{
    const ServoConfig& servo = m_config.servo;
    TrajectoryLimits result{.velocity = limitOr(command.velocityLimit, servo.defaultVelocityLimit),
                            .acceleration = limitOr(command.accelerationLimit, servo.defaultAccelLimit)};
    if (std::isinf(result.velocity) && std::isfinite(result.acceleration)) {
        result.velocity = servo.maxVelocity;
    }
    if (std::isfinite(result.velocity)) {
        result.velocity = std::min(result.velocity, velocityLimitOfSupply(m_config, busVoltage));
    }
    return result;
}

PositionBounds ServoControl::bounds(const ServoCommand& command) const
{
    PositionBounds result;
    if (command.ignorePositionBounds) {
        return result;
    }
    if (std::isfinite(m_config.positionMin)) {
        result.min = m_config.positionMin;
    }
    if (std::isfinite(m_config.positionMax)) {
        result.max = m_config.positionMax;
    }
    return result;
}

void ServoControl::step(double dt, Mode mode, const ServoInputs& inputs, const ServoCommand& command)
{
    m_output = {.loss = kIdlePower};
    m_limit = ActiveLimit::None;
    m_torque = kNone;
    switch (mode) {
        case Mode::Position:
            controlPosition(dt, inputs, command);
            break;
        case Mode::PositionTimeout:
            controlTimeout(dt, inputs, command);
            break;
        case Mode::ZeroVelocity:
            controlZeroVelocity(dt, inputs, command);
            break;
        case Mode::StayWithin:
            controlStayWithin(dt, inputs, command);
            break;
        case Mode::Current:
            driveCurrent(command.qCurrent, inputs, false);
            break;
        case Mode::VoltageDq:
            driveCurrent(
                (command.qVoltage - voltagePerVelocity(m_config) * inputs.velocity) / m_config.motor.resistance, inputs,
                false);
            break;
        case Mode::Brake:
            brake();
            break;
        default:  // no torque: stopped, fault, enabling, and the open-loop modes, which Boresight does not use
            m_terms = {};
            break;
    }
    if (moteus::isLimit(inputs.persistentFault) && controlsPosition(mode)) {
        m_limit = static_cast<ActiveLimit>(inputs.persistentFault);
    }
}

void ServoControl::controlTimeout(double dt, const ServoInputs& inputs, const ServoCommand& command)
{
    switch (static_cast<Mode>(m_config.servo.timeoutMode)) {
        case Mode::Position:
            controlPosition(dt, inputs, ServoCommand{.mode = Mode::Position, .position = kNone});
            break;
        case Mode::ZeroVelocity:
            controlZeroVelocity(dt, inputs, command);
            break;
        case Mode::Brake:
            brake();
            break;
        default:  // driver off
            m_terms = {};
            break;
    }
}

void ServoControl::controlPosition(double dt, const ServoInputs& inputs, const ServoCommand& command)
{
    m_planner.step(dt, limits(command, inputs.busVoltage), bounds(command));
    m_trajectoryComplete = m_planner.state().complete;
    if (const double slip = m_config.servo.maxPositionSlip; std::isfinite(slip)) {
        m_planner.moveTo(std::clamp(m_planner.state().position, inputs.position - slip, inputs.position + slip));
    }
    applyGains(dt, inputs, command);
    driveTorque(inputs, command);
}

// Damping only, with the torque that the configuration allows after a time-out.
void ServoControl::controlZeroVelocity(double dt, const ServoInputs& inputs, const ServoCommand& command)
{
    m_planner.capture(inputs.position, 0.0);
    ServoCommand damping{.mode = Mode::ZeroVelocity,
                         .kpScale = 0.0,
                         .kdScale = command.kdScale,
                         .maximumTorque = m_config.servo.timeoutMaxTorque,
                         .integralLimitScale = 0.0};
    applyGains(dt, inputs, damping);
    driveTorque(inputs, damping);
}

void ServoControl::controlStayWithin(double dt, const ServoInputs& inputs, const ServoCommand& command)
{
    double nearest = inputs.position;
    if (command.stayWithinLower > nearest) {
        nearest = command.stayWithinLower;
    } else if (command.stayWithinUpper < nearest) {
        nearest = command.stayWithinUpper;
    }
    m_planner.capture(nearest, 0.0);
    if (nearest == inputs.position) {
        m_terms = {.feedforward = command.feedforwardTorque, .total = command.feedforwardTorque};
    } else {
        applyGains(dt, inputs, command);
    }
    driveTorque(inputs, command);
}

void ServoControl::applyGains(double dt, const ServoInputs& inputs, const ServoCommand& command)
{
    const ServoGains& gains = m_config.servo.gains;
    const double error = inputs.position - m_planner.state().position;
    const double velocityError = inputs.velocity - m_planner.state().velocity;
    const double mostIntegral = std::max(gains.ilimit * command.integralLimitScale, 0.0);
    const double rate =
        gains.iratelimit < 0.0 ? -gains.ki * error : std::clamp(-gains.ki * error, -gains.iratelimit, gains.iratelimit);
    m_terms.integral = std::clamp(m_terms.integral + rate * dt, -mostIntegral, mostIntegral);
    m_terms.proportional = -gains.kp * command.kpScale * error;
    m_terms.derivative = -gains.kd * command.kdScale * velocityError;
    m_terms.feedforward = command.feedforwardTorque;
    const double accelerating =
        2.0 * std::numbers::pi * m_planner.state().acceleration * m_config.servo.inertiaFeedforward;
    m_terms.total = m_terms.proportional + m_terms.integral + m_terms.derivative + m_terms.feedforward + accelerating;
}

void ServoControl::driveTorque(const ServoInputs& inputs, const ServoCommand& command)
{
    double torque = m_terms.total;
    if (std::abs(torque) > command.maximumTorque) {  // never true for NaN
        torque = std::copysign(command.maximumTorque, torque);
        m_limit = ActiveLimit::CommandedTorque;
    }
    m_torque = torque;
    const bool boundsApply = !command.ignorePositionBounds && command.mode != Mode::ZeroVelocity;
    driveCurrent(torque / torquePerAmpere(m_config), inputs, boundsApply);
}

void ServoControl::driveCurrent(double amperes, const ServoInputs& inputs, bool boundsApply)
{
    const LimitedCurrent limited = limitedCurrent(amperes, m_config,
                                                  {.position = inputs.position,
                                                   .velocity = inputs.velocity,
                                                   .busVoltage = inputs.busVoltage,
                                                   .fetTemperature = inputs.fetTemperature,
                                                   .motorTemperature = inputs.motorTemperature,
                                                   .boundsApply = boundsApply});
    if (limited.limit != ActiveLimit::None) {
        m_limit = limited.limit;
    }
    m_output.qCurrent = limited.amperes;
    m_output.torque = limited.amperes * torquePerAmpere(m_config);
    m_output.dCurrent = fluxBrakeCurrent(m_config, inputs.busVoltage);
    if (m_output.dCurrent > 0.0) {
        m_limit = ActiveLimit::FluxBraking;
    }
    const double squared = m_output.qCurrent * m_output.qCurrent + m_output.dCurrent * m_output.dCurrent;
    m_output.power = motorPower(m_config, m_output.qCurrent, m_output.dCurrent, inputs.velocity);
    m_output.loss += kServoPowerFactor * kBoardResistance * squared;
}

void ServoControl::brake()
{
    m_terms = {};
    m_output.braking = true;
}

}  // namespace boresight::sim
