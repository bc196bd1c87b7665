// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>

// The trajectory generator inside a moteus: from the present control position and velocity to a target that may
// itself move, with bounded velocity and acceleration (bang-bang, no jerk limit). Pure; turns of the output, seconds.
// The device steps at 30 kHz; the closed form used here is exact at any step, so that a coarse step gives the same
// trajectory.
namespace boresight::sim {

struct TrajectoryLimits
{
    double velocity = std::numeric_limits<double>::infinity();      // turns/s, infinite: none
    double acceleration = std::numeric_limits<double>::infinity();  // turns/s²
};

// The line position + velocity·t from the moment of the command; without a position only the velocity is reached.
struct TrajectoryTarget
{
    std::optional<double> position;
    double velocity = 0.0;
};

struct PositionBounds
{
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
};

struct ControlState
{
    double position = 0.0;
    double velocity = 0.0;
    double acceleration = 0.0;
    bool complete = false;  // the end velocity is reached, and the target if there is one
};

class TrajectoryPlanner
{
public:
    // Starts from a measured state; the completion flag is kept until a target is in force.
    void capture(double position, double velocity);

    // A new line began `age` seconds before the next step begins; negative: it begins within that step.
    void setTarget(const TrajectoryTarget& target, double age);

    void step(double dt, const TrajectoryLimits& limits, const PositionBounds& bounds);

    // The frame of reference moved by `offset`: control position and target move along.
    void shift(double offset);
    // The set-point is dragged to a position (limited slip, output position set); velocity as it was.
    void moveTo(double position) { m_state.position = position; }

    [[nodiscard]] const ControlState& state() const { return m_state; }

private:
    void stepWithoutAccelerationLimit(double dt, const TrajectoryLimits& limits);
    void stepToVelocity(double dt, const TrajectoryLimits& limits);
    void stepToPosition(double dt, const TrajectoryLimits& limits);
    void clampTo(const PositionBounds& bounds);
    [[nodiscard]] double clampedTargetVelocity(const TrajectoryLimits& limits) const;

    ControlState m_state;
    TrajectoryTarget m_target;
};

}  // namespace boresight::sim
