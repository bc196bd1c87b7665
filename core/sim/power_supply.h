// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The supply of the drives, and how warm the boards get. Pure. Units: V, Ω, F, W, °C, s. The voltage sags by the source
// resistance. Power from braking charges the capacitors of the boards, because an ordinary supply does not accept it.
namespace boresight::sim {

struct SupplySettings
{
    double voltage = 24.0;
    double sourceResistance = 0.1;
    double capacitance = 2.0e-3;  // both boards together
    bool absorbs = false;         // true for a battery, which accepts energy
};

class PowerSupply
{
public:
    explicit PowerSupply(const SupplySettings& settings);

    void step(double dt, double loadPower);
    void setVoltage(double voltage) { m_settings.voltage = voltage; }
    void setOn(bool on);
    [[nodiscard]] bool isOn() const { return m_on; }
    [[nodiscard]] double voltage() const { return m_voltage; }

private:
    SupplySettings m_settings;
    bool m_on = true;
    double m_voltage = 0.0;
};

// Moves in first order towards ambient temperature plus loss times thermal resistance: 29 °C when idle, time constant 3
// minutes.
class BoardTemperature
{
public:
    void step(double dt, double lossPower);
    [[nodiscard]] double celsius() const { return m_celsius; }

private:
    double m_celsius = 29.0;
};

}  // namespace boresight::sim
