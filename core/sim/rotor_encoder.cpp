// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/rotor_encoder.h"

#include <cmath>

namespace boresight::sim {
namespace {

constexpr double kRotorEncoderCountsPerTurn = 16384.0;  // 14 bits
constexpr double kPositionNoise = 1.0;                  // counts
constexpr double kVelocityNoise = 0.01;                 // rotor turns/s, after the filter

double fraction(double turns)
{
    return turns - std::floor(turns);
}

// 0…1. A servo reads its encoder many thousand times a second, and std::uniform_real_distribution works out two
// logarithms for each number.
double fractionOfOne(std::minstd_rand& random)
{
    constexpr double range = double(std::minstd_rand::max()) - double(std::minstd_rand::min());
    return double(random() - std::minstd_rand::min()) / range;
}

}  // namespace

void RotorEncoder::sample(double rotorTurns, double rotorVelocity, double outputTurns)
{
    m_raw =
        std::floor(rotorTurns * kRotorEncoderCountsPerTurn + noise(kPositionNoise) + 0.5) / kRotorEncoderCountsPerTurn;
    const double velocity = rotorVelocity + noise(kVelocityNoise);
    m_velocity = velocity * m_config.motorPosition.rotorToOutputRatio * m_config.motorPosition.outputSign;
    m_output = outputTurns;
}

void RotorEncoder::latchAtPowerUp()
{
    m_first = m_raw;
    m_turnOffset = -std::round(m_raw);
    m_home = moteus::HomeState::Rotor;
    if (m_config.motorPosition.referenceSource == 1) {
        setNearest(m_output - std::round(m_output));
    }
}

void RotorEncoder::beginAnew()
{
    ++m_beginnings;
    latchAtPowerUp();
}

void RotorEncoder::requireReindex()
{
    m_turnOffset = -std::round(m_raw);
    m_home = moteus::HomeState::Relative;
}

double RotorEncoder::setNearest(double position)
{
    const double before = this->position();
    m_turnOffset = std::round(toCounted(position) - m_raw);
    m_home = moteus::HomeState::Output;
    return this->position() - before;
}

double RotorEncoder::setExact(double position)
{
    const double before = this->position();
    m_turnOffset = toCounted(position) - m_raw;
    m_home = moteus::HomeState::Output;
    return this->position() - before;
}

// setNearest() chooses the whole turn, and the configured offset corrects the rest. The offset stays once it is stored.
double RotorEncoder::setConfiguredOffset(DriveConfig& config, double position)
{
    const double before = this->position();
    config.motorPosition.outputOffset = 0.0;
    setNearest(position);
    config.motorPosition.outputOffset = (position - this->position()) * config.motorPosition.outputSign;
    return this->position() - before;
}

double RotorEncoder::position() const
{
    return toOutput(m_raw + m_turnOffset);
}

double RotorEncoder::relative() const
{
    return (m_raw - m_first) * m_config.motorPosition.rotorToOutputRatio * m_config.motorPosition.outputSign;
}

double RotorEncoder::fractionOfTurn() const
{
    return fraction(m_raw);
}

double RotorEncoder::outputFractionOfTurn() const
{
    return fraction(m_output);
}

double RotorEncoder::toOutput(double counted) const
{
    const MotorPositionConfig& config = m_config.motorPosition;
    return (counted * config.rotorToOutputRatio + config.outputOffset) * config.outputSign;
}

double RotorEncoder::toCounted(double position) const
{
    const MotorPositionConfig& config = m_config.motorPosition;
    return (position * config.outputSign - config.outputOffset) / config.rotorToOutputRatio;
}

double RotorEncoder::noise(double amplitude)
{
    return m_noise.enabled ? amplitude * (2.0 * fractionOfOne(m_random) - 1.0) : 0.0;
}

}  // namespace boresight::sim
