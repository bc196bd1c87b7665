// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/servo.h"

#include "core/moteus/faults.h"

#include <cmath>

namespace boresight::sim {
namespace {

using moteus::Mode;

// The gate driver needs 4 to 5 ms to start. Calibrating the current sensors takes 256 control periods of 1/30000 s.
constexpr double kEnablingTime = 5.0e-3;
constexpr double kCalibratingTime = 256.0 / 30000.0;
constexpr double kTimeTolerance = 1.0e-9;  // rounding errors in sums of steps

constexpr double kLargestPosition = 32768.0;  // turns: the largest position of the device

enum FaultCode : int
{
    kGateDriverFault = 33,
    kOverVoltage = 34,
    kEncoderFault = 35,
    kMotorNotConfigured = 36,
    kOverTemperature = 38,
    kOutsideBounds = 39,
    kUnderVoltage = 40,
    kNoCommutation = 42,
    kNoPosition = 43,
    kStopPositionWithLimits = 45,
    kBoundsTooLarge = 48,
    kPositionError = 49,
    kVelocityError = 50,
};

constexpr double kLowestVoltage = 4.0;

bool isPositionMode(Mode mode)
{
    return mode == Mode::Position || mode == Mode::StayWithin;
}

bool isEnabling(Mode mode)
{
    return mode == Mode::Enabling || mode == Mode::Calibrating || mode == Mode::CalibrationComplete;
}

bool exceeds(double value, double threshold)
{
    return std::isfinite(threshold) && value > threshold;
}

}  // namespace

bool Servo::isActive() const
{
    return m_mode != Mode::Stopped && m_mode != Mode::Fault;
}

// The device checks position and velocity error wherever it controls the position, so also after a time-out.
bool Servo::followsSetpoint() const
{
    const bool holdsAfterTimeout =
        m_mode == Mode::PositionTimeout && m_config.servo.timeoutMode == static_cast<int>(Mode::Position);
    return m_mode == Mode::Position || holdsAfterTimeout;
}

void Servo::command(const ServoCommand& command, double age)
{
    const bool passedThrough = command.mode == Mode::Fault || isEnabling(command.mode);
    if (!passedThrough) {
        m_arrived = command;
        m_arrivedAge = age;
    }
}

void Servo::raiseFault(int code)
{
    m_arrived.reset();
    m_fault = code;
    enter(Mode::Fault);
}

const ServoOutput& Servo::step(double dt, const ServoInputs& inputs)
{
    m_timeInMode += dt;
    if (m_arrived) {
        takeCommand(inputs);
    }
    advanceEnabling(inputs);
    checkWatchdog();
    if (const int fault = isActive() ? supervisionFault(inputs) : 0; fault != 0) {
        raiseFault(fault);
    }
    m_control.step(dt, m_mode, inputs, m_command);
    m_commandAge += dt;
    return output();
}

void Servo::enter(Mode mode)
{
    m_mode = mode;
    m_timeInMode = 0.0;
}

// Stop always works and clears a fault. It is the only way out of fault and time-out.
void Servo::takeCommand(const ServoInputs& inputs)
{
    const ServoCommand command = *m_arrived;
    m_arrived.reset();
    if (command.mode == Mode::Stopped) {
        m_fault = 0;
        enter(Mode::Stopped);
        return;
    }
    if (m_mode == Mode::Fault || m_mode == Mode::PositionTimeout) {
        return;
    }
    const TrajectoryLimits limit = m_control.limits(command, inputs.busVoltage);
    if (std::isfinite(command.stopPosition) && (std::isfinite(limit.velocity) || std::isfinite(limit.acceleration))) {
        raiseFault(kStopPositionWithLimits);
        return;
    }
    m_command = command;
    m_commandAge = m_arrivedAge;
    if (m_mode == Mode::Stopped) {
        m_config.motor.poles == 0 ? raiseFault(kMotorNotConfigured) : enter(Mode::Enabling);
    } else if (!isEnabling(m_mode)) {
        engage(inputs);
    }
}

void Servo::advanceEnabling(const ServoInputs& inputs)
{
    if (m_mode == Mode::CalibrationComplete) {
        engage(inputs);
    } else if (m_mode == Mode::Enabling && m_timeInMode >= kEnablingTime - kTimeTolerance) {
        const double over = m_timeInMode - kEnablingTime;
        enter(Mode::Calibrating);
        m_timeInMode = over;
    } else if (m_mode == Mode::Calibrating && m_timeInMode >= kCalibratingTime - kTimeTolerance) {
        enter(Mode::CalibrationComplete);
    }
}

// Puts the commanded mode in force, or a further command of the mode that is in force.
void Servo::engage(const ServoInputs& inputs)
{
    const Mode before = m_mode;
    if (before != m_command.mode) {
        if (const int fault = entryFault(inputs); fault != 0) {
            raiseFault(fault);
            return;
        }
        enter(m_command.mode);
        if (before != Mode::Position) {
            recapture(inputs);
            m_control.forgetTerms();
        }
    }
    if (m_mode == Mode::Position) {
        m_control.setTarget(m_command, m_commandAge);
    } else if (m_mode == Mode::PositionTimeout) {
        m_control.stop();
    }
}

void Servo::checkWatchdog()
{
    if (!isPositionMode(m_mode)) {
        return;
    }
    const double asked = m_command.watchdogTimeout;
    const double timeout = asked == 0.0 ? m_config.servo.defaultTimeout : asked;
    if (m_commandAge >= timeout - kTimeTolerance) {  // never true for NaN
        enter(Mode::PositionTimeout);
        m_control.stop();
    }
}

int Servo::supervisionFault(const ServoInputs& inputs) const
{
    const ServoConfig& servo = m_config.servo;
    if (inputs.persistentFault != 0 && !moteus::isLimit(inputs.persistentFault)) {
        return inputs.persistentFault;
    }
    if (inputs.gateDriverFault) {
        return kGateDriverFault;
    }
    if (inputs.busVoltage > servo.maxVoltage) {
        return kOverVoltage;
    }
    if (inputs.busVoltage < kLowestVoltage) {
        return kUnderVoltage;
    }
    const bool motorHot = servo.enableMotorTemperature && exceeds(inputs.motorTemperature, servo.motorFaultTemperature);
    if (motorHot || exceeds(inputs.fetTemperature, servo.faultTemperature)) {
        return kOverTemperature;
    }
    if (!followsSetpoint()) {
        return 0;
    }
    if (exceeds(std::abs(inputs.position - control().position), servo.faultPositionError)) {
        return kPositionError;
    }
    return exceeds(std::abs(inputs.velocity - control().velocity), servo.faultVelocityError) ? kVelocityError : 0;
}

int Servo::entryFault(const ServoInputs& inputs) const
{
    if (inputs.encoderError) {
        return kEncoderFault;
    }
    const bool openLoop = m_command.mode == Mode::Brake || m_command.mode == Mode::Pwm ||
                          m_command.mode == Mode::Voltage || m_command.mode == Mode::VoltageFoc;
    if (!inputs.commutationValid && !openLoop) {
        return kNoCommutation;
    }
    if (!isPositionMode(m_command.mode)) {
        return 0;
    }
    if (!inputs.positionValid) {
        return kNoPosition;
    }
    const auto tooLarge = [](double bound) { return std::isfinite(bound) && std::abs(bound) > kLargestPosition; };
    if (tooLarge(m_config.positionMin) || tooLarge(m_config.positionMax)) {
        return kBoundsTooLarge;
    }
    const PositionBounds allowed = m_control.bounds(m_command);
    return inputs.position < allowed.min || inputs.position > allowed.max ? kOutsideBounds : 0;
}

}  // namespace boresight::sim
