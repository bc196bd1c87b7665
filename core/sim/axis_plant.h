// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>

// The mechanics of one axis that a drive turns: inertia, static, Coulomb and viscous friction, the weight of an
// unbalanced antenna, wind, backlash, end stops and blockage. Pure. Units: turns of the gearbox output in the direction
// of the drive, seconds, Nm at the output. Friction is integrated as an impulse that may stop the axis but never
// reverse it. So an axis that stands still stays still with any step length.
namespace boresight::sim {

struct PlantSettings
{
    double inertia = 20.0;         // kg·m² at the output, with the rotor behind the gearbox
    double coulombFriction = 3.0;  // Nm while moving
    double staticFriction = 4.0;   // Nm to break away
    double viscousFriction = 5.0;  // Nm/(rad/s)
    double gravityTorque = 0.0;    // Nm towards positive turns while the antenna points at the horizon
    double levelAt = 0.0;          // turns at which the antenna points at the horizon
    double backlash = 0.0;         // turns: the whole gap between gearbox and load
    double loadShare = 0.0;        // share of inertia and friction that the motor does not feel inside the gap
    double stopMin = -std::numeric_limits<double>::infinity();  // hard end stops
    double stopMax = std::numeric_limits<double>::infinity();
};

struct PlantLoads
{
    double driveTorque = 0.0;   // Nm
    double brakeDamping = 0.0;  // Nm/(rad/s): shorted motor phases
    double windTorque = 0.0;    // Nm
};

class AxisPlant
{
public:
    AxisPlant(const PlantSettings& settings, double position);

    void step(double dt, const PlantLoads& loads);

    // Turns the axis by hand. It stands still afterwards.
    void place(double position);
    // Something is in the way: at a position of the travel (setJam), or where the axis is now (setStalled).
    void setJam(std::optional<double> position) { m_jam = position; }
    void setStalled(bool stalled) { m_stalled = stalled; }
    [[nodiscard]] PlantSettings& settings() { return m_settings; }

    [[nodiscard]] double position() const { return m_position; }  // of the gearbox output
    [[nodiscard]] double velocity() const { return m_velocity; }
    // The position of the antenna, behind the backlash.
    [[nodiscard]] double loadPosition() const { return m_position + m_lag; }

private:
    [[nodiscard]] bool carriesLoad(double direction, double loadTorque) const;
    [[nodiscard]] double nextVelocity(double dt, const PlantLoads& loads, double loadTorque) const;
    void move(double to);
    void followLoad(double dt, double moved, double loadTorque);

    PlantSettings m_settings;
    double m_position = 0.0;
    double m_velocity = 0.0;
    double m_lag = 0.0;  // position of the load minus that of the gearbox output, within ± half the backlash
    std::optional<double> m_jam;
    bool m_stalled = false;
};

}  // namespace boresight::sim
