// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/drive_config.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/sim/reference_mount.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace boresight::sim {
namespace {

void visitServo(ServoConfig& servo, const ConfigVisitor& visit)
{
    visit("servo.max_voltage", &servo.maxVoltage);
    visit("servo.max_power_W", &servo.maxPower);
    visit("servo.temperature_margin", &servo.temperatureMargin);
    visit("servo.fault_temperature", &servo.faultTemperature);
    visit("servo.enable_motor_temperature", &servo.enableMotorTemperature);
    visit("servo.motor_temperature_margin", &servo.motorTemperatureMargin);
    visit("servo.motor_fault_temperature", &servo.motorFaultTemperature);
    visit("servo.fault_position_error", &servo.faultPositionError);
    visit("servo.fault_velocity_error", &servo.faultVelocityError);
    visit("servo.position_derate", &servo.positionDerate);
    visit("servo.pid_position.kp", &servo.gains.kp);
    visit("servo.pid_position.ki", &servo.gains.ki);
    visit("servo.pid_position.kd", &servo.gains.kd);
    visit("servo.pid_position.iratelimit", &servo.gains.iratelimit);
    visit("servo.pid_position.ilimit", &servo.gains.ilimit);
    visit("servo.inertia_feedforward", &servo.inertiaFeedforward);
    visit("servo.default_velocity_limit", &servo.defaultVelocityLimit);
    visit("servo.default_accel_limit", &servo.defaultAccelLimit);
    visit("servo.max_position_slip", &servo.maxPositionSlip);
    visit("servo.default_timeout_s", &servo.defaultTimeout);
    visit("servo.timeout_max_torque_Nm", &servo.timeoutMaxTorque);
    visit("servo.timeout_mode", &servo.timeoutMode);
    visit("servo.flux_brake_margin_voltage", &servo.fluxBrakeMarginVoltage);
    visit("servo.flux_brake_resistance_ohm", &servo.fluxBrakeResistance);
    visit("servo.max_current_A", &servo.maxCurrent);
    visit("servo.max_velocity", &servo.maxVelocity);
    visit("servo.max_velocity_derate", &servo.maxVelocityDerate);
    visit("servo.velocity_zero_capture_threshold", &servo.velocityZeroCaptureThreshold);
}

void visitPins(DriveConfig& config, const ConfigVisitor& visit)
{
    for (const int port : {1, 2}) {
        for (int pin = 0; pin < static_cast<int>(config.pins.modes[0].size()); ++pin) {
            visit("aux" + std::to_string(port) + ".pins." + std::to_string(pin) + ".mode", &config.pinMode(port, pin));
        }
    }
}

std::optional<ConfigField> findField(DriveConfig& config, std::string_view key)
{
    std::optional<ConfigField> found;
    visitFields(config, [&](std::string_view name, ConfigField field) {
        if (name == key) {
            found = field;
        }
    });
    return found;
}

Error unknownKey(std::string_view key)
{
    return {ErrorCode::InvalidInput, QStringLiteral("unknown configuration key %1").arg(toQString(key))};
}

std::string floatText(double value)
{
    return std::isnan(value) ? "nan" : std::isinf(value) ? (value < 0 ? "-inf" : "inf") : formatFixed(value, 6);
}

double parsedLikeTheDevice(std::string_view text)
{
    if (text == "nan") {
        return kNone;
    }
    return parseFinite(text).value_or(0.0);
}

struct FieldText
{
    std::string operator()(const double* value) const { return floatText(*value); }
    std::string operator()(const int* value) const { return std::to_string(*value); }
    std::string operator()(const bool* value) const { return *value ? "1" : "0"; }
    std::string operator()(const std::uint8_t* value) const { return std::to_string(*value); }
};

struct FieldWriter
{
    double value;

    void operator()(double* field) const { *field = value; }
    void operator()(int* field) const { *field = static_cast<int>(whole(-2147483648.0, 2147483647.0)); }
    void operator()(bool* field) const { *field = value != 0.0; }
    void operator()(std::uint8_t* field) const { *field = static_cast<std::uint8_t>(whole(0.0, 255.0)); }

    [[nodiscard]] double whole(double least, double most) const
    {
        return std::isnan(value) ? 0.0 : std::clamp(value, least, most);
    }
};

}  // namespace

void visitFields(DriveConfig& config, const ConfigVisitor& visit)
{
    visit("id.id", &config.id);
    visit("can.prefix", &config.canPrefix);
    for (std::size_t i = 0; i < config.uuid.size(); ++i) {
        visit("uuid.uuid." + std::to_string(i), &config.uuid[i]);
    }
    visitServo(config.servo, visit);
    visit("servopos.position_min", &config.positionMin);
    visit("servopos.position_max", &config.positionMax);
    visit("motor.poles", &config.motor.poles);
    visit("motor.phase_invert", &config.motor.phaseInvert);
    visit("motor.resistance_ohm", &config.motor.resistance);
    visit("motor.Kv", &config.motor.kv);
    visit("motor_position.sources.0.pll_filter_hz", &config.motorPosition.pllFilter);
    visit("motor_position.rotor_to_output_ratio", &config.motorPosition.rotorToOutputRatio);
    visit("motor_position.output.source", &config.motorPosition.outputSource);
    visit("motor_position.output.offset", &config.motorPosition.outputOffset);
    visit("motor_position.output.sign", &config.motorPosition.outputSign);
    visit("motor_position.output.reference_source", &config.motorPosition.referenceSource);
    visitPins(config, visit);
}

Result<std::string> configText(DriveConfig& config, std::string_view key)
{
    const std::optional<ConfigField> field = findField(config, key);
    if (!field) {
        return tl::unexpected(unknownKey(key));
    }
    return std::visit(FieldText{}, *field);
}

Result<> setConfigText(DriveConfig& config, std::string_view key, std::string_view text)
{
    const std::optional<ConfigField> field = findField(config, key);
    if (!field) {
        return tl::unexpected(unknownKey(key));
    }
    std::visit(FieldWriter{parsedLikeTheDevice(text)}, *field);
    if (config.id < 1 || config.id > 126) {
        config.id = 1;  // the firmware does the same with an address that it cannot use
    }
    config.motorPosition.outputSign = config.motorPosition.outputSign < 0 ? -1 : 1;
    return {};
}

DriveConfig commissionedDrive(Axis axis)
{
    DriveConfig config = commissionedDrive(axis == Axis::Azimuth ? 1 : 2, referenceAxis(axis));
    config.servo.defaultAccelLimit = axis == Axis::Azimuth ? 0.35 : 0.28;
    return config;
}

DriveConfig commissionedDrive(int id, const ReferenceAxis& mount)
{
    const Angle margin = 3.0_deg;
    const double low = mount.toTurns(mount.travel.min - margin);
    const double high = mount.toTurns(mount.travel.max + margin);
    DriveConfig config;
    config.id = id;
    config.positionMin = std::min(low, high);
    config.positionMax = std::max(low, high);
    config.motorPosition.rotorToOutputRatio = 1.0 / mount.gearRatio;
    config.servo.gains = mount.gains;
    // A tenth below the true inertia, as a measurement would give it. Without this value, the axis runs on after a
    // braking ramp until the gains have found the torque, and then returns: 0.1 s longer from full speed.
    config.servo.inertiaFeedforward = 0.9 * mount.plant.inertia;
    config.servo.timeoutMode = 10;
    config.servo.faultPositionError = Angle(10.0_deg).turns();
    // Four times the torque of the fastest move in calm air, a quarter of what the gearbox survives.
    config.servo.maxCurrent = 30.0;
    config.servo.maxVelocity = 0.06;
    config.servo.maxVelocityDerate = 0.01;
    // With these default limits the drive brakes after its host died: 14.4°/s, full stop in 80 ms. With a watchdog of
    // 0.1 s the axis stands still 0.2 s after the last command.
    config.servo.defaultVelocityLimit = 0.04;
    config.servo.defaultAccelLimit = 0.35;
    return config;
}

}  // namespace boresight::sim
