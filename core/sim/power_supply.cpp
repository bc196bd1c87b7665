// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/power_supply.h"

#include <algorithm>

namespace boresight::sim {
namespace {

constexpr double kThermalResistance = 6.0;  // K/W, board in free air
constexpr double kAmbient = 20.0;           // °C
constexpr double kThermalCapacity = 30.0;   // J/K

}  // namespace

PowerSupply::PowerSupply(const SupplySettings& settings) : m_settings(settings), m_voltage(settings.voltage) {}

// The source current is solved implicitly, which is stable even if the capacitors react much faster than one step.
void PowerSupply::step(double dt, double loadPower)
{
    if (!m_on) {
        return;
    }
    const double store = m_settings.capacitance / dt;
    const double drawn = loadPower / std::max(m_voltage, 1.0);
    const double charged = m_voltage - drawn / store;
    const bool feeds = m_settings.absorbs || charged < m_settings.voltage;
    const double source = feeds ? 1.0 / m_settings.sourceResistance : 0.0;
    m_voltage = (store * charged + source * m_settings.voltage) / (store + source);
    m_voltage = std::max(m_voltage, 0.0);
}

void PowerSupply::setOn(bool on)
{
    m_on = on;
    m_voltage = on ? m_settings.voltage : 0.0;
}

void BoardTemperature::step(double dt, double lossPower)
{
    const double flow = lossPower - (m_celsius - kAmbient) / kThermalResistance;
    m_celsius += dt * flow / kThermalCapacity;
}

}  // namespace boresight::sim
