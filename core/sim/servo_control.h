// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus/registers.h"
#include "core/sim/current_limits.h"
#include "core/sim/drive_config.h"
#include "core/sim/trajectory_planner.h"

// The control loop of one moteus: from the command in force to torque, within all limits. Which mode is in force is
// the business of Servo. Pure, stepped by it; turns of the output, Nm at the output, V, °C, s. A command holds what
// the command registers hold, so NaN means what it means there.
namespace boresight::sim {

struct ServoCommand
{
    moteus::Mode mode = moteus::Mode::Stopped;
    double position = 0.0;  // NaN: keep the control position and reach only the velocity
    double velocity = 0.0;
    double feedforwardTorque = 0.0;
    double kpScale = 1.0;
    double kdScale = 1.0;
    double maximumTorque = 100.0;  // NaN: only the current limit
    double stopPosition = kNone;
    double watchdogTimeout = 0.0;      // 0: configured, NaN: never, negative: at once
    double velocityLimit = kNone;      // NaN: configured, negative: none
    double accelerationLimit = kNone;  // NaN: configured, negative: none
    double integralLimitScale = 1.0;
    bool ignorePositionBounds = false;
    double stayWithinLower = 0.0;
    double stayWithinUpper = 0.0;
    double qCurrent = 0.0;
    double dCurrent = 0.0;
    double qVoltage = 0.0;
    double dVoltage = 0.0;
};

// What the board measures, and conditions that are not as they should be.
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
    // Code of an injected cause: a fault returns whenever the driver is enabled, a limit (96…105) is told while it is.
    int persistentFault = 0;
};

struct PidTerms
{
    double proportional = 0.0;
    double integral = 0.0;
    double derivative = 0.0;
    double feedforward = 0.0;
    double total = 0.0;  // wanted, before the current limits
};

struct ServoOutput
{
    double torque = 0.0;   // on the output
    bool braking = false;  // phases shorted
    double qCurrent = 0.0;
    double dCurrent = 0.0;
    double power = 0.0;  // electrical, negative while braking
    double loss = 0.0;   // heat on the board, its own consumption included
};

// Control set-points exist in this mode.
[[nodiscard]] bool controlsPosition(moteus::Mode mode);

class ServoControl
{
public:
    explicit ServoControl(const DriveConfig& config) : m_config(config) {}

    // One step in `mode`. The command is used where the mode has one.
    void step(double dt, moteus::Mode mode, const ServoInputs& inputs, const ServoCommand& command);

    // Set-points restart from the measured state.
    void capture(const ServoInputs& inputs);
    // The frame of the output position moved; set-points go along.
    void shift(double offset) { m_planner.shift(offset); }
    // `age`: as of TrajectoryPlanner::setTarget.
    void setTarget(const ServoCommand& command, double age);
    // To velocity zero, wherever that is.
    void stop() { m_planner.setTarget({}, 0.0); }
    void forgetTerms() { m_terms = {}; }

    // What a command and the configuration leave of velocity, acceleration and position.
    [[nodiscard]] TrajectoryLimits limits(const ServoCommand& command, double busVoltage) const;
    [[nodiscard]] PositionBounds bounds(const ServoCommand& command) const;

    [[nodiscard]] const ServoOutput& output() const { return m_output; }
    [[nodiscard]] const PidTerms& terms() const { return m_terms; }
    [[nodiscard]] const ControlState& state() const { return m_planner.state(); }
    [[nodiscard]] ActiveLimit limit() const { return m_limit; }
    [[nodiscard]] bool trajectoryComplete() const { return m_trajectoryComplete; }
    [[nodiscard]] double torque() const { return m_torque; }  // wanted; NaN: none is controlled

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
