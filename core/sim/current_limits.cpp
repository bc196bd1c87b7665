// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/current_limits.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace boresight::sim {
namespace {

constexpr double kTorqueTimesKv = 8.27;       // Nm/A · rpm/V, of a three-phase motor counted in peak phase current
constexpr double kUncalibratedTorque = 0.1;   // Nm/A at the rotor
constexpr double kUncalibratedCurrent = 5.0;  // A
constexpr double kBridgeCurrent = 100.0;      // A: the most that the board can carry, for any command
constexpr double kModulation = 0.5;           // highest phase voltage as a share of the bus voltage
constexpr double kPowerFactor = 1.5;          // three phases counted in peak values

double rotorTorquePerAmpere(const MotorConfig& motor)
{
    return motor.kv > 0.0 ? kTorqueTimesKv / motor.kv : kUncalibratedTorque;
}

// 1 up to `start`, falling to 0 at `start + width`. Without a finite start there is no limit.
double fade(double value, double start, double width)
{
    if (!std::isfinite(start)) {
        return 1.0;
    }
    const double over = value - start;
    return width > 0.0 ? std::clamp(1.0 - over / width, 0.0, 1.0) : (over > 0.0 ? 0.0 : 1.0);
}

// The limit of the board: 900 W up to 30 V, 400 W from 38 V on.
double maximumPower(const ServoConfig& servo, double busVoltage)
{
    const double board = 900.0 - 500.0 * std::clamp((busVoltage - 30.0) / 8.0, 0.0, 1.0);
    return std::isfinite(servo.maxPower) ? std::min(servo.maxPower, board) : board;
}

class Limiter
{
public:
    explicit Limiter(double wanted) : m_current{.amperes = wanted, .limit = ActiveLimit::None} {}

    void toMagnitude(double most, ActiveLimit limit)
    {
        most = std::max(most, 0.0);
        if (std::abs(m_current.amperes) > most) {
            m_current = {.amperes = std::copysign(most, m_current.amperes), .limit = limit};
        }
    }
    void byFactor(double factor, ActiveLimit limit)
    {
        if (factor < 1.0 && m_current.amperes != 0.0) {
            m_current = {.amperes = m_current.amperes * factor, .limit = limit};
        }
    }
    [[nodiscard]] bool pushes(double direction) const { return m_current.amperes * direction > 0.0; }
    [[nodiscard]] LimitedCurrent result() const { return m_current; }

private:
    LimitedCurrent m_current;
};

void limitByMotion(Limiter& limiter, const DriveConfig& config, const ElectricalState& state)
{
    const double outside = std::max(state.position - config.positionMax, config.positionMin - state.position);
    const double outward = state.position > config.positionMax ? 1.0 : -1.0;
    if (state.boundsApply && outside > 0.0 && limiter.pushes(outward)) {
        limiter.byFactor(fade(outside, 0.0, config.servo.positionDerate), ActiveLimit::PositionBounds);
    }
    if (limiter.pushes(state.velocity)) {
        limiter.byFactor(fade(std::abs(state.velocity), config.servo.maxVelocity, config.servo.maxVelocityDerate),
                         ActiveLimit::MaxVelocity);
    }
}

}  // namespace

double torquePerAmpere(const DriveConfig& config)
{
    return rotorTorquePerAmpere(config.motor) / config.motorPosition.rotorToOutputRatio;
}

double voltagePerVelocity(const DriveConfig& config)
{
    return torquePerAmpere(config) * 2.0 * std::numbers::pi / kPowerFactor;
}

double brakeDamping(const DriveConfig& config)
{
    return torquePerAmpere(config) * voltagePerVelocity(config) / (config.motor.resistance * 2.0 * std::numbers::pi);
}

double motorPower(const DriveConfig& config, double qCurrent, double dCurrent, double velocity)
{
    const double mechanical = qCurrent * torquePerAmpere(config) * velocity * 2.0 * std::numbers::pi;
    return mechanical + kPowerFactor * config.motor.resistance * (qCurrent * qCurrent + dCurrent * dCurrent);
}

double velocityLimitOfSupply(const DriveConfig& config, double busVoltage)
{
    // 0.41 times the bus voltage, divided by the back electromotive force, which is 34.6/Kv at the rotor (fact sheet,
    // planner).
    return 0.41 * busVoltage / (34.6 / std::max(config.motor.kv, 1.0)) * config.motorPosition.rotorToOutputRatio;
}

LimitedCurrent limitedCurrent(double wanted, const DriveConfig& config, const ElectricalState& state)
{
    const ServoConfig& servo = config.servo;
    Limiter limiter(std::isfinite(wanted) ? wanted : 0.0);
    limiter.toMagnitude(kBridgeCurrent, ActiveLimit::MaxCurrent);
    limitByMotion(limiter, config, state);
    limiter.toMagnitude(config.motor.kv > 0.0 ? servo.maxCurrent : kUncalibratedCurrent, ActiveLimit::MaxCurrent);
    limiter.toMagnitude(servo.maxCurrent * fade(state.fetTemperature, servo.faultTemperature - servo.temperatureMargin,
                                                servo.temperatureMargin),
                        ActiveLimit::FetTemperature);
    if (servo.enableMotorTemperature) {
        limiter.toMagnitude(
            servo.maxCurrent * fade(state.motorTemperature, servo.motorFaultTemperature - servo.motorTemperatureMargin,
                                    servo.motorTemperatureMargin),
            ActiveLimit::MotorTemperature);
    }
    const double backEmf = voltagePerVelocity(config) * std::abs(state.velocity);
    if (limiter.pushes(state.velocity) && backEmf > 0.0) {
        limiter.toMagnitude(maximumPower(servo, state.busVoltage) / (kPowerFactor * backEmf), ActiveLimit::MaxPower);
        limiter.toMagnitude(std::max(kModulation * state.busVoltage - backEmf, 0.0) / config.motor.resistance,
                            ActiveLimit::BusVoltage);
    }
    return limiter.result();
}

double fluxBrakeCurrent(const DriveConfig& config, double busVoltage)
{
    const ServoConfig& servo = config.servo;
    const double over = busVoltage - (servo.maxVoltage - servo.fluxBrakeMarginVoltage);
    const double most = std::min(kBridgeCurrent, std::max(servo.maxCurrent, 0.0));
    return over > 0.0 ? std::min(over / std::max(servo.fluxBrakeResistance, 1e-3), most) : 0.0;
}

}  // namespace boresight::sim
