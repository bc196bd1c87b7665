// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus/registers.h"
#include "core/sim/current_limits.h"
#include "core/sim/drive_config.h"
#include "core/sim/trajectory_planner.h"

// The control loop of one moteus: from the command in force to a torque within all limits. Servo decides which mode is
// in force. Pure, stepped by Servo. Units: turns of the output, Nm at the output, V, °C, s. A command has the values of
// the command registers, and NaN has the meaning that it has there.
namespace boresight::sim {

struct ServoCommand
{
    moteus::Mode mode = moteus::Mode::Stopped;
    double position = 0.0;  // NaN: keep the control position and only reach the velocity
    double velocity = 0.0;
    double feedforwardTorque = 0.0;
    double kpScale = 1.0;
    double kdScale = 1.0;
    double maximumTorque = 100.0;  // NaN: only the current limit
    double stopPosition = kNone;
    double watchdogTimeout = 0.0;      // s. 0: as configured, NaN: never, negative: at once
    double velocityLimit = kNone;      // NaN: as configured, negative: none
    double accelerationLimit = kNone;  // NaN: as configured, negative: none
    double integralLimitScale = 1.0;
    bool ignorePositionBounds = false;
    double stayWithinLower = 0.0;
    double stayWithinUpper = 0.0;
    double qCurrent = 0.0;
    double dCurrent = 0.0;
    double qVoltage = 0.0;
    double dVoltage = 0.0;
};

// The measured values of the board, and its error conditions.
struct ServoInputs
{
    double position = 0.0;
    double velocity = 0.0;
    double busVoltage = 24.0;
    double fetTemperature = 30.0;
    double motorTemperature = 0.0;
    bool positionValid = true;
    bool commutationValid = true;
    bool encoderError = false;
    bool gateDriverFault = false;
    // Code of an injected cause. A fault returns whenever the driver is enabled. A limit (96…105) is reported while it
    // is enabled.
    int persistentFault = 0;
};

struct PidTerms
{
    double proportional = 0.0;
    double integral = 0.0;
    double derivative = 0.0;
    double feedforward = 0.0;
    double total = 0.0;  // before the current limits
};

struct ServoOutput
{
    double torque = 0.0;   // on the output
    bool braking = false;  // phases shorted
    double qCurrent = 0.0;
    double dCurrent = 0.0;
    double power = 0.0;  // electrical; negative while braking
    double loss = 0.0;   // heat on the board, with its own consumption
};

// True if the mode has control set-points.
[[nodiscard]] bool controlsPosition(moteus::Mode mode);

class ServoControl
{
public:
    explicit ServoControl(const DriveConfig& config) : m_config(config) {}

    // One step in `mode`. Modes without a command ignore `command`.
    void step(double dt, moteus::Mode mode, const ServoInputs& inputs, const ServoCommand& command);

    // Set-points restart from the measured state.
    void capture(const ServoInputs& inputs);
    // The zero of the output position moved by `offset`. Set-points move along.
    void shift(double offset) { m_planner.shift(offset); }
    // `age`: as in TrajectoryPlanner::setTarget.
    void setTarget(const ServoCommand& command, double age);
    // To velocity zero, at any position.
    void stop() { m_planner.setTarget({}, 0.0); }
    void forgetTerms() { m_terms = {}; }

    // The limits of velocity, acceleration and position from the command and the configuration.
    [[nodiscard]] TrajectoryLimits limits(const ServoCommand& command, double busVoltage) const;
    [[nodiscard]] PositionBounds bounds(const ServoCommand& command) const;

    [[nodiscard]] const ServoOutput& output() const { return m_output; }
    [[nodiscard]] const PidTerms& terms() const { return m_terms; }
    [[nodiscard]] const ControlState& state() const { return m_planner.state(); }
    [[nodiscard]] ActiveLimit limit() const { return m_limit; }
    [[nodiscard]] bool trajectoryComplete() const { return m_trajectoryComplete; }
    [[nodiscard]] double torque() const { return m_torque; }  // wanted; NaN: the mode controls no torque

private:
    void controlPosition(double dt, const ServoInputs& inputs, const ServoCommand& command);
    void controlTimeout(double dt, const ServoInputs& inputs, const ServoCommand& command);
    void controlZeroVelocity(double dt, const ServoInputs& inputs, const ServoCommand& command);
    void controlStayWithin(double dt, const ServoInputs& inputs, const ServoCommand& command);
    void brake();
    void applyGains(double dt, const ServoInputs& inputs, const ServoCommand& command);
    void driveTorque(const ServoInputs& inputs, const ServoCommand& command);
    void driveCurrent(double amperes, const ServoInputs& inputs, bool boundsApply);

    const DriveConfig& m_config;
    TrajectoryPlanner m_planner;
    PidTerms m_terms;
    ServoOutput m_output;
    ActiveLimit m_limit = ActiveLimit::None;
    bool m_trajectoryComplete = false;
    double m_torque = kNone;
};

}  // namespace boresight::sim
