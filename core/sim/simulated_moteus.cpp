// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/simulated_moteus.h"

#include "core/moteus/pin_query.h"
#include "core/sim/command_registers.h"
#include "core/sim/drive_telemetry.h"

namespace boresight::sim {
namespace {

using moteus::Register;

constexpr int kConfigurationChanged = 41;

}  // namespace

SimulatedMoteus::SimulatedMoteus(const MoteusSettings& settings)
    : m_settings(settings),
      m_stored(settings.config),
      m_config(settings.config),
      m_plant(settings.plant, settings.position)
{
    m_machine.motor = settings.motor;
    m_machine.motorPosition.rotorToOutputRatio = 1.0 / settings.gearRatio;
    powerUp();
    m_uptime = settings.uptime;
    if (settings.referenced) {
        m_encoder->setNearest(settings.position);
    }
}

void SimulatedMoteus::powerUp()
{
    m_config = m_stored;
    m_encoder.emplace(m_config, m_settings.noise);
    m_servo.emplace(m_config);
    m_console.reset();
    m_server = {};
    m_writes.forget();
    m_uptime = 0.0;
    sampleEncoder();
    m_encoder->latchAtPowerUp();
    m_inputs = {.position = m_encoder->position()};
}

void SimulatedMoteus::setPowered(bool powered)
{
    if (powered && !m_powered) {
        powerUp();
    }
    m_powered = powered;
}

void SimulatedMoteus::place(double position)
{
    m_plant.place(position);
    sampleEncoder();
}

void SimulatedMoteus::step(double dt, const Surroundings& surroundings)
{
    PlantLoads loads{.windTorque = surroundings.windTorque};
    if (m_powered) {
        m_uptime += dt;
        m_inputs.position = m_encoder->position();
        m_inputs.velocity = m_encoder->velocity();
        m_inputs.busVoltage = surroundings.busVoltage;
        m_inputs.fetTemperature = m_board.celsius();
        m_inputs.persistentFault = surroundings.persistentFault;
        const ServoOutput& output = m_servo->step(dt, m_inputs);
        loads.driveTorque = outputTorque();
        loads.brakeDamping = output.braking ? brakeDamping(m_machine) : 0.0;
        m_console.advance(dt);
    }
    m_board.step(dt, m_powered ? m_servo->output().loss : 0.0);
    m_plant.step(dt, loads);
    sampleEncoder();
}

void SimulatedMoteus::setPin(int port, int pin, bool isHigh)
{
    unsigned& pins = m_pins.at(static_cast<std::size_t>(port - 1));
    const unsigned bit = 1U << static_cast<unsigned>(pin);
    pins = isHigh ? pins | bit : pins & ~bit;
}

void SimulatedMoteus::makeOutput(int port, int pin)
{
    m_config.pinMode(port, pin) = moteus::kDigitalOutput;
    m_stored.pinMode(port, pin) = moteus::kDigitalOutput;
}

bool SimulatedMoteus::isDrivenHigh(int port, int pin)
{
    const auto reg = static_cast<Register>(static_cast<int>(Register::AuxGpioCommand) + port - 1);
    const auto outputs = static_cast<unsigned>(m_writes.accepted(reg).value_or(0.0));
    return m_powered && m_config.pinMode(port, pin) == moteus::kDigitalOutput &&
           (outputs >> static_cast<unsigned>(pin) & 1U) != 0;
}

void SimulatedMoteus::sampleEncoder()
{
    m_encoder->sample((m_plant.position() + m_slip) * m_settings.gearRatio, m_plant.velocity() * m_settings.gearRatio,
                      m_plant.loadPosition());
}

std::optional<CanFrame> SimulatedMoteus::exchange(const CanFrame& request, double age, std::optional<int> answerAs)
{
    if (!m_powered) {
        return std::nullopt;
    }
    m_writes.begin();
    m_age = age;
    const moteus::DeviceAddress address{.id = static_cast<std::uint8_t>(answerAs.value_or(m_config.id)),
                                        .prefix = static_cast<std::uint16_t>(m_config.canPrefix)};
    return m_server.serve(request, address, *this);
}

// A frame counts as a whole. If the frame ends with a UUID mask that does not match, none of its writes has an effect.
void SimulatedMoteus::completeFrame(FrameEnd end)
{
    if (end == FrameEnd::Discarded) {
        return;
    }
    m_writes.accept();
    for (const moteus::RegisterValue& action : m_writes.actions()) {
        if (action.reg == Register::SetOutputNearest) {
            setOutputNearest(action.value);
        } else if (action.reg == Register::SetOutputExact) {
            setOutputExact(action.value);
        } else if (action.reg == Register::RequireReindex) {
            requireReindex();
        } else {
            recapture();
        }
    }
    if (m_writes.hasMode()) {
        m_servo->command(m_writes.command(), m_age);
    }
}

// A pin that is no digital input reads 0.
std::array<unsigned, 2> SimulatedMoteus::readPins() const
{
    std::array<unsigned, 2> read = m_pins;
    for (std::size_t port = 0; port < read.size(); ++port) {
        for (std::size_t pin = 0; pin < m_config.pins.modes[port].size(); ++pin) {
            read[port] &= m_config.pins.modes[port][pin] == PinConfig::kDigitalInput ? ~0U : ~(1U << pin);
        }
    }
    return read;
}

DriveState SimulatedMoteus::state() const
{
    return {.config = m_config,
            .servo = *m_servo,
            .inputs = m_inputs,
            .encoder = *m_encoder,
            .board = m_board,
            .plant = m_plant,
            .uptime = m_uptime,
            .pins = readPins(),
            .registerMapVersion = m_registerMapVersion};
}

double SimulatedMoteus::readRegister(Register reg)
{
    if (const auto commanded = readCommand(m_writes.command(), reg)) {
        return *commanded;
    }
    if (const auto shown = readState(state(), reg)) {
        return *shown;
    }
    const auto written = m_writes.unused(reg);
    return written ? *written : readSensor(state(), reg);
}

std::vector<std::string> SimulatedMoteus::telemetryChannels() const
{
    return sim::telemetryChannels();
}

std::vector<ArchiveField> SimulatedMoteus::telemetry(std::string_view channel)
{
    return sim::telemetry(state(), channel);
}

void SimulatedMoteus::receiveText(std::uint32_t, std::span<const std::uint8_t> text)
{
    m_console.receive(text);
}

std::span<const std::uint8_t> SimulatedMoteus::pendingText(std::uint32_t)
{
    return m_console.pending();
}

void SimulatedMoteus::dropText(std::uint32_t, std::size_t count)
{
    m_console.drop(count);
}

// The encoder settings must not change while the servo runs: it goes into fault. The encoder starts again as at
// power-up.
void SimulatedMoteus::configChanged(std::string_view group)
{
    if (group != "motor_position") {
        return;
    }
    sampleEncoder();
    m_encoder->beginAnew();
    if (m_servo->isActive()) {
        m_servo->raiseFault(kConfigurationChanged);
    }
}

void SimulatedMoteus::loadConfig()
{
    m_config = m_stored;
    configChanged("motor_position");
}

void SimulatedMoteus::defaultConfig()
{
    DriveConfig factory;
    factory.uuid = m_config.uuid;
    m_config = factory;
    configChanged("motor_position");
}

void SimulatedMoteus::configureOutput(double position)
{
    m_servo->shiftFrame(m_encoder->setConfiguredOffset(m_config, position));
}

void SimulatedMoteus::requireReindex()
{
    const double before = m_encoder->position();
    m_encoder->requireReindex();
    m_servo->shiftFrame(m_encoder->position() - before);
}

// The drive counts and pushes in the direction of its output sign.
double SimulatedMoteus::motorCurrent() const
{
    return m_powered ? m_servo->output().qCurrent * m_config.motorPosition.outputSign : 0.0;
}

double SimulatedMoteus::reportedPosition() const
{
    return readState(state(), Register::Position).value_or(kNone);
}

double SimulatedMoteus::outputTorque() const
{
    return motorCurrent() * torquePerAmpere(m_machine);
}

double SimulatedMoteus::supplyPower() const
{
    if (!m_powered) {
        return 0.0;
    }
    const ServoOutput& output = m_servo->output();
    return motorPower(m_machine, motorCurrent(), output.dCurrent, m_plant.velocity()) + output.loss;
}

}  // namespace boresight::sim
