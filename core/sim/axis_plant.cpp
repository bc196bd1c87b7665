// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/axis_plant.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace boresight::sim {
namespace {

constexpr double kRadiansPerTurn = 2.0 * std::numbers::pi;

// A load that is pushed by its own weight or by the wind crosses the gap in this time.
constexpr double kBacklashCrossing = 0.05;  // s

}  // namespace

AxisPlant::AxisPlant(const PlantSettings& settings, double position) : m_settings(settings), m_position(position) {}

void AxisPlant::step(double dt, const PlantLoads& loads)
{
    const double angle = kRadiansPerTurn * (m_position - m_settings.levelAt);
    const double loadTorque = m_settings.gravityTorque * std::cos(angle) + loads.windTorque;
    const double before = m_position;
    const double velocity = m_stalled ? 0.0 : nextVelocity(dt, loads, loadTorque);
    const double target = m_position + 0.5 * (m_velocity + velocity) * dt;
    m_velocity = velocity;
    if (!m_stalled) {
        move(target);
    }
    followLoad(dt, m_position - before, loadTorque);
}

void AxisPlant::place(double position)
{
    m_position = position;
    m_velocity = 0.0;
}

// True if the motor feels the load. With loadShare 0 the motor feels the load all the time. A load that is pushed rests
// on one flank, so the gear moves it in both directions.
bool AxisPlant::carriesLoad(double direction, double loadTorque) const
{
    const double half = 0.5 * m_settings.backlash;
    return m_settings.loadShare == 0.0 || half == 0.0 || std::abs(loadTorque) > 0.25 * m_settings.staticFriction ||
           (direction < 0.0 ? m_lag >= half : m_lag <= -half);
}

double AxisPlant::nextVelocity(double dt, const PlantLoads& loads, double loadTorque) const
{
    const double direction = m_velocity != 0.0 ? m_velocity : loads.driveTorque + loadTorque;
    const double felt = carriesLoad(direction, loadTorque) ? 1.0 : 1.0 - m_settings.loadShare;
    const double perInertia = dt / (felt * m_settings.inertia * kRadiansPerTurn);  // Nm -> change of turns/s
    const double damping = (felt * m_settings.viscousFriction + loads.brakeDamping) * kRadiansPerTurn;
    const double pushed = (m_velocity + (loads.driveTorque + loadTorque) * perInertia) / (1.0 + damping * perInertia);
    const double friction = felt * (m_velocity == 0.0 ? m_settings.staticFriction : m_settings.coulombFriction);
    const double stopped = friction * perInertia;
    return std::abs(pushed) <= stopped ? 0.0
                                       : pushed - std::copysign(felt * m_settings.coulombFriction * perInertia, pushed);
}

void AxisPlant::move(double to)
{
    const bool blocked = m_jam && (m_position - *m_jam) * (to - *m_jam) <= 0.0 && m_position != to;
    if (blocked) {
        m_velocity = 0.0;
        return;
    }
    m_position = std::clamp(to, m_settings.stopMin, m_settings.stopMax);
    if (m_position != to) {
        m_velocity = 0.0;  // inelastic stop
    }
}

// A load that is pushed rests on one flank of the gear. Otherwise the gear takes the load along when the gap closes.
void AxisPlant::followLoad(double dt, double moved, double loadTorque)
{
    const double half = 0.5 * m_settings.backlash;
    const bool carried = carriesLoad(moved, loadTorque);
    m_lag -= moved;
    if (std::abs(loadTorque) > 0.25 * m_settings.staticFriction) {
        m_lag += moved + std::copysign(m_settings.backlash * std::min(dt / kBacklashCrossing, 1.0), loadTorque);
    }
    m_lag = std::clamp(m_lag, -half, half);
    if (!carried && carriesLoad(moved, loadTorque)) {
        m_velocity *= 1.0 - m_settings.loadShare;  // the motor meets the load and shares its momentum with it
    }
}

}  // namespace boresight::sim
