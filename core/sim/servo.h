// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus/registers.h"
#include "core/sim/drive_config.h"
#include "core/sim/servo_control.h"

#include <optional>

// The servo of one moteus: decides which mode is in force, from commands, the enabling sequence, the watchdog and
// faults. ServoControl contains what a mode does to the motor. Pure, stepped by its owner. Units are those of
// ServoControl.
namespace boresight::sim {

class Servo
{
public:
    explicit Servo(const DriveConfig& config) : m_config(config), m_control(config) {}

    // `age`: how many seconds before the next step the command arrived. Negative: it arrives within that step.
    void command(const ServoCommand& command, double age = 0.0);
    void raiseFault(int code);
    const ServoOutput& step(double dt, const ServoInputs& inputs);

    // The zero of the output position moved by `offset`. Set-points move along.
    void shiftFrame(double offset) { m_control.shift(offset); }
    // Set-points restart from the measured state.
    void recapture(const ServoInputs& inputs) { m_control.capture(inputs); }

    [[nodiscard]] moteus::Mode mode() const { return m_mode; }
    // In mode 1 the fault, else the limit that is active now. 0: none.
    [[nodiscard]] int faultCode() const { return m_fault != 0 ? m_fault : static_cast<int>(m_control.limit()); }
    [[nodiscard]] bool isActive() const;  // the driver is enabled or being enabled
    [[nodiscard]] bool controlsPosition() const { return sim::controlsPosition(m_mode); }
    [[nodiscard]] const ServoOutput& output() const { return m_control.output(); }
    [[nodiscard]] const PidTerms& terms() const { return m_control.terms(); }
    [[nodiscard]] const ControlState& control() const { return m_control.state(); }
    [[nodiscard]] bool trajectoryComplete() const { return m_control.trajectoryComplete(); }
    [[nodiscard]] double controlTorque() const { return m_control.torque(); }

private:
    void enter(moteus::Mode mode);
    void takeCommand(const ServoInputs& inputs);
    void advanceEnabling(const ServoInputs& inputs);
    void engage(const ServoInputs& inputs);
    void checkWatchdog();
    [[nodiscard]] bool followsSetpoint() const;
    [[nodiscard]] int supervisionFault(const ServoInputs& inputs) const;
    [[nodiscard]] int entryFault(const ServoInputs& inputs) const;

    const DriveConfig& m_config;
    ServoControl m_control;
    moteus::Mode m_mode = moteus::Mode::Stopped;
    int m_fault = 0;
    ServoCommand m_command;                 // in force, or waiting until the driver is enabled
    std::optional<ServoCommand> m_arrived;  // used at the next step
    double m_arrivedAge = 0.0;
    double m_commandAge = 0.0;
    double m_timeInMode = 0.0;
};

}  // namespace boresight::sim
