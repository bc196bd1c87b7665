// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What feeds the drives, and how warm they get. Pure; V, Ω, F, W, °C, s. The supply sags by its source resistance;
// power that braking feeds back charges the capacitors of the boards, because an ordinary supply does not take it.
namespace boresight::sim {

struct SupplySettings
{
    double voltage = 24.0;
    double sourceResistance = 0.1;
    double capacitance = 2.0e-3;  // of both boards
    bool absorbs = false;         // a battery takes energy back
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

// First order towards ambient plus loss · thermal resistance: about 30 °C when idle, a time constant of 3 minutes.
class BoardTemperature
{
public:
    void step(double dt, double lossPower);
    [[nodiscard]] double celsius() const { return m_celsius; }

private:
    double m_celsius = 29.0;
};

}  // namespace boresight::sim
