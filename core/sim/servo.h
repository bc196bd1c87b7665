// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus/registers.h"
#include "core/sim/current_limits.h"
#include "core/sim/drive_config.h"
#include "core/sim/trajectory_planner.h"

#include <optional>

// The servo of one moteus: mode state machine with enabling sequence and watchdog, position control and its limits,
// faults. Pure, stepped by its owner; turns of the output, Nm at the output, V, °C, s. A command holds what the
// command registers hold, so NaN means what it means there.
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

class Servo
{
public:
    explicit Servo(const DriveConfig& config) : m_config(config) {}

    // Arrived `age` seconds before the next step begins; negative: within it.
    void command(const ServoCommand& command, double age = 0.0);
    void raiseFault(int code);
    const ServoOutput& step(double dt, const ServoInputs& inputs);

    // The frame of the output position moved; set-points go along.
    void shiftFrame(double offset) { m_planner.shift(offset); }
    // Set-points restart from the measured state.
    void recapture(const ServoInputs& inputs);

    [[nodiscard]] moteus::Mode mode() const { return m_mode; }
    // A fault in mode 1, else the limit that is active now.
    [[nodiscard]] int faultCode() const { return m_fault != 0 ? m_fault : static_cast<int>(m_limit); }
    [[nodiscard]] bool isActive() const;          // driver enabled or being enabled
    [[nodiscard]] bool controlsPosition() const;  // control set-points exist
    [[nodiscard]] const ServoOutput& output() const { return m_output; }
    [[nodiscard]] const PidTerms& terms() const { return m_terms; }
    [[nodiscard]] const ControlState& control() const { return m_planner.state(); }
    [[nodiscard]] bool trajectoryComplete() const { return m_trajectoryComplete; }
    [[nodiscard]] double controlTorque() const { return m_controlTorque; }

private:
    void enter(moteus::Mode mode);
    void takeCommand(const ServoInputs& inputs);
    void advanceEnabling(const ServoInputs& inputs);
    void engage(const ServoInputs& inputs);
    void checkWatchdog();
    [[nodiscard]] bool followsSetpoint() const;
    [[nodiscard]] int supervisionFault(const ServoInputs& inputs) const;
    [[nodiscard]] int entryFault(const ServoInputs& inputs) const;

    void control(double dt, const ServoInputs& inputs);
    void controlTimeout(double dt, const ServoInputs& inputs);
    void controlPosition(double dt, const ServoInputs& inputs, const ServoCommand& command);
    void controlZeroVelocity(double dt, const ServoInputs& inputs);
    void controlStayWithin(double dt, const ServoInputs& inputs);
    void brake();
    void applyGains(double dt, const ServoInputs& inputs, const ServoCommand& command);
    void driveTorque(const ServoInputs& inputs, const ServoCommand& command);
    void driveCurrent(double amperes, const ServoInputs& inputs, bool boundsApply);
    [[nodiscard]] static TrajectoryTarget targetOf(const ServoCommand& command);
    [[nodiscard]] TrajectoryLimits limits(const ServoCommand& command, double busVoltage) const;
    [[nodiscard]] PositionBounds bounds(const ServoCommand& command) const;

    const DriveConfig& m_config;
    TrajectoryPlanner m_planner;
    moteus::Mode m_mode = moteus::Mode::Stopped;
    int m_fault = 0;
    ActiveLimit m_limit = ActiveLimit::None;
    ServoCommand m_command;                 // in force, or waiting for the end of enabling
    std::optional<ServoCommand> m_arrived;  // taken at the next step
    double m_arrivedAge = 0.0;
    double m_commandAge = 0.0;
    double m_timeInMode = 0.0;
    PidTerms m_terms;
    ServoOutput m_output;
    bool m_trajectoryComplete = false;
    double m_controlTorque = kNone;
};

}  // namespace boresight::sim
