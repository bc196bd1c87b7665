// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus/frame_server.h"
#include "core/sim/axis_plant.h"
#include "core/sim/diagnostic_console.h"
#include "core/sim/frame_writes.h"
#include "core/sim/power_supply.h"
#include "core/sim/rotor_encoder.h"
#include "core/sim/servo.h"
#include "core/sim/state_registers.h"

#include <optional>

// One simulated moteus r4.11 with its motor, gearbox and axis: power-up, physics, frames, configuration memory.
// state_registers.h contains the registers that show its state, FrameWrites the registers that are written. Pure,
// stepped by its owner. Answers a frame at once, and the reply shows the state before the command.
//
// More than 15 members: the parts of one board and its memory, which start together at power-up.
namespace boresight::sim {

struct MoteusSettings
{
    DriveConfig config{};  // as stored in the memory of the board
    MotorConfig motor{};   // as built, which the configuration may contradict
    PlantSettings plant{};
    double position = 0.0;     // of the axis, turns of the gearbox output
    double gearRatio = 100.0;  // turns of the rotor per turn of the output
    bool referenced = false;   // the output position was set since power-up
    double uptime = 60.0;      // seconds since power-up, at the start of the simulation
    EncoderNoise noise{};
};

class SimulatedMoteus final : public moteus::ServedDevice, private ConsoleDevice
{
public:
    explicit SimulatedMoteus(const MoteusSettings& settings);
    SimulatedMoteus(const SimulatedMoteus&) = delete;
    SimulatedMoteus& operator=(const SimulatedMoteus&) = delete;

    // Conditions for the next step. SimulatedPair sets them.
    struct Surroundings
    {
        double busVoltage = 24.0;
        double windTorque = 0.0;  // Nm in the drive's sense
        int persistentFault = 0;
    };
    void step(double dt, const Surroundings& surroundings);

    // `age`: seconds between the arrival of the frame and the beginning of the next step. `answerAs`: answer with this
    // id.
    [[nodiscard]] std::optional<CanFrame> exchange(const CanFrame& request, double age,
                                                   std::optional<int> answerAs = std::nullopt);

    void setPowered(bool powered);
    // Turns the axis by hand without power, so the drive does not see the movement.
    void place(double position);
    // From here on the encoder reads `turns` more.
    void slipEncoder(double turns) { m_slip += turns; }
    void raiseFault(int code) { m_servo->raiseFault(code); }
    void setRegisterMapVersion(int version) { m_registerMapVersion = version; }
    [[nodiscard]] bool isPowered() const { return m_powered; }
    // What is wired to an aux pin. At first every pin is high.
    void setPin(int port, int pin, bool isHigh);
    // Changes the configuration as stored in the memory of the board.
    void makeOutput(int port, int pin);
    // What an aux pin drives. False: low, or the pin is no output.
    [[nodiscard]] bool isDrivenHigh(int port, int pin);

    [[nodiscard]] AxisPlant& plant() { return m_plant; }
    [[nodiscard]] const AxisPlant& plant() const { return m_plant; }
    [[nodiscard]] const Servo& servo() const { return *m_servo; }
    [[nodiscard]] const DriveConfig& driveConfig() const { return m_config; }
    [[nodiscard]] double reportedPosition() const;  // turns as register 0x001 shows them
    [[nodiscard]] double outputTorque() const;      // Nm at the gearbox output
    [[nodiscard]] double supplyPower() const;       // W drawn from the supply, negative while braking

    // The interface for the frame server.
    [[nodiscard]] double readRegister(moteus::Register reg) override;
    [[nodiscard]] std::uint32_t writeRegister(moteus::Register reg, double value) override
    {
        return m_writes.write(reg, value);
    }
    void completeFrame(FrameEnd end) override;
    [[nodiscard]] bool hasChannel(std::uint32_t channel) override { return channel == 1; }
    void receiveText(std::uint32_t channel, std::span<const std::uint8_t> text) override;
    [[nodiscard]] std::span<const std::uint8_t> pendingText(std::uint32_t channel) override;
    void dropText(std::uint32_t channel, std::size_t count) override;

private:
    // The interface for the console.
    DriveConfig& config() override { return m_config; }
    void configChanged(std::string_view group) override;
    void storeConfig() override { m_stored = m_config; }
    void loadConfig() override;
    void defaultConfig() override;
    void consoleCommand(const ServoCommand& command) override { m_servo->command(command); }
    void setOutputExact(double position) override { m_servo->shiftFrame(m_encoder->setExact(position)); }
    void setOutputNearest(double position) override { m_servo->shiftFrame(m_encoder->setNearest(position)); }
    void configureOutput(double position) override;
    void requireReindex() override;
    void recapture() override { m_servo->recapture(m_inputs); }
    [[nodiscard]] std::vector<std::string> telemetryChannels() const override;
    [[nodiscard]] std::vector<ArchiveField> telemetry(std::string_view channel) override;

    void powerUp();
    void sampleEncoder();
    [[nodiscard]] double motorCurrent() const;  // A, towards positive turns of the rotor
    [[nodiscard]] std::array<unsigned, 2> readPins() const;
    [[nodiscard]] DriveState state() const;

    static constexpr unsigned kFivePins = 0x1f;

    MoteusSettings m_settings;
    DriveConfig m_machine;  // true motor and gear
    DriveConfig m_stored;   // survives a loss of power
    DriveConfig m_config;
    AxisPlant m_plant;
    BoardTemperature m_board;
    std::optional<RotorEncoder> m_encoder;  // made again at power-up, like the servo
    std::optional<Servo> m_servo;
    ServoInputs m_inputs;
    DiagnosticConsole m_console{*this};
    moteus::FrameServer m_server;
    bool m_powered = true;
    double m_slip = 0.0;  // turns of the axis
    std::array<unsigned, 2> m_pins{kFivePins, kFivePins};
    double m_uptime = 0.0;
    int m_registerMapVersion = moteus::kRegisterMapVersion;
    FrameWrites m_writes;
    double m_age = 0.0;  // of the frame being served
};

}  // namespace boresight::sim
