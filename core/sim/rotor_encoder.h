// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus/registers.h"
#include "core/sim/drive_config.h"

#include <cstdint>
#include <random>

// The encoder of a drive and the frame its position counts in. The AS5047P on the board knows one rotor turn of 16384
// counts; the whole turns since power-up are counted by the drive and lost with the power. Pure; turns of the rotor or
// the output as named.
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

    // What the sensors see now: rotor turns since for ever, and the turn of the output.
    void sample(double rotorTurns, double rotorVelocity, double outputTurns);

    // The output is somewhere within half a rotor turn of zero, unless an absolute encoder sits on the output.
    void latchAtPowerUp();
    // Other settings of the encoders: as at power-up, and the drive counts from zero again.
    void beginAnew();
    void requireReindex();
    // Both return by how much the output position jumped.
    double setNearest(double position);
    double setExact(double position);
    double setConfiguredOffset(DriveConfig& config, double position);

    [[nodiscard]] double position() const;  // of the output
    [[nodiscard]] double velocity() const { return m_velocity; }
    [[nodiscard]] double relative() const;  // of the output, counted since the beginning; nobody can set it
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
    double m_raw = 0.0;         // turns of the rotor as measured, never wrapped
    double m_output = 0.0;      // turns of the output as the second encoder sees it
    double m_velocity = 0.0;    // of the output
    double m_turnOffset = 0.0;  // counted = raw + offset
    double m_first = 0.0;       // raw, at the beginning
    int m_beginnings = 1;
    moteus::HomeState m_home = moteus::HomeState::Relative;
};

}  // namespace boresight::sim
