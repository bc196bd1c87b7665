// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus/registers.h"
#include "core/sim/drive_config.h"

#include <cstdint>
#include <random>

// The encoder of a drive, and the zero that its position counts from. The AS5047P on the board measures the angle
// within one turn of the rotor (16384 counts). The drive counts the whole turns since power-up and loses them with the
// power. Pure. Turns of the rotor or of the output, as named.
namespace boresight::sim {

struct EncoderNoise
{
    bool enabled = true;
    std::uint32_t seed = 1;
};

class RotorEncoder
{
public:
    RotorEncoder(const DriveConfig& config, const EncoderNoise& noise) : m_config(config), m_noise(noise) {}

    // One reading of the sensors: turns of the rotor (never wrapped) and turns of the output.
    void sample(double rotorTurns, double rotorVelocity, double outputTurns);

    // After power-up the output position is within half a turn of the rotor from zero, unless the output has an
    // absolute encoder.
    void latchAtPowerUp();
    // The settings of the encoders changed. As at power-up, the drive counts from zero again.
    void beginAnew();
    void requireReindex();
    // All three return by how much the output position jumped.
    double setNearest(double position);
    double setExact(double position);
    double setConfiguredOffset(DriveConfig& config, double position);

    [[nodiscard]] double position() const;  // of the output
    [[nodiscard]] double velocity() const { return m_velocity; }
    [[nodiscard]] double relative() const;  // of the output, counted since power-up or beginAnew(); it cannot be set
    [[nodiscard]] int beginnings() const { return m_beginnings; }
    [[nodiscard]] double fractionOfTurn() const;        // of the rotor, 0…1
    [[nodiscard]] double outputFractionOfTurn() const;  // of the second encoder, if there is one
    [[nodiscard]] moteus::HomeState homeState() const { return m_home; }

private:
    [[nodiscard]] double toOutput(double counted) const;
    [[nodiscard]] double toCounted(double position) const;
    [[nodiscard]] double noise(double amplitude);

    const DriveConfig& m_config;
    EncoderNoise m_noise;
    std::minstd_rand m_random{m_noise.seed};
    double m_raw = 0.0;         // measured turns of the rotor, never wrapped
    double m_output = 0.0;      // turns of the output, measured by the second encoder
    double m_velocity = 0.0;    // of the output
    double m_turnOffset = 0.0;  // counted = raw + offset
    double m_first = 0.0;       // m_raw at power-up or beginAnew()
    int m_beginnings = 1;
    moteus::HomeState m_home = moteus::HomeState::Relative;
};

}  // namespace boresight::sim
