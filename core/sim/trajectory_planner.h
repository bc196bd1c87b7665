// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>

// The trajectory planner inside a moteus: moves the control position and velocity to a target that may itself move,
// with limited velocity and acceleration (bang-bang, no jerk limit). It works in the control periods of the device,
// because they decide how it behaves near a target: it rounds the distance to whole counts of 2^-16 turns, and drops
// the target when it is less than ten periods of travel away. Pure. Turns of the output, seconds.
namespace boresight::sim {

struct TrajectoryLimits
{
    double velocity = std::numeric_limits<double>::infinity();      // turns/s; infinite: no limit
    double acceleration = std::numeric_limits<double>::infinity();  // turns/s²; infinite: no limit
};

// The line position + velocity·t from the time of the command on. Without a position only the velocity is reached.
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
    bool complete = false;  // the end velocity and the target position (if any) are reached
};

class TrajectoryPlanner
{
public:
    // Starts from a measured state. The completion flag is kept until a target is in force.
    void capture(double position, double velocity);

    // A new line began `age` seconds before the next step. Negative: it begins within that step.
    void setTarget(const TrajectoryTarget& target, double age);

    // Runs all control periods that begin before the end of `dt`.
    void step(double dt, const TrajectoryLimits& limits, const PositionBounds& bounds);

    // The zero of the position moved by `offset`. Control position and target move along.
    void shift(double offset);
    // Moves the set-point to a position (limited slip, output position set). The velocity stays.
    void moveTo(double position) { m_state.position = position; }

    [[nodiscard]] const ControlState& state() const { return m_state; }

private:
    void runPeriods(int count, const TrajectoryLimits& limits);
    void runPeriod(const TrajectoryLimits& limits);
    void approachAtSpeed(double speed, double distance);
    void approachVelocity(double acceleration);
    void approachTarget(const TrajectoryLimits& limits, double distance);
    void reached();
    [[nodiscard]] double distance() const;
    [[nodiscard]] bool arrives(double acceleration, double distance, double before, double applied) const;

    ControlState m_state;
    TrajectoryTarget m_target;
    double m_owed = 0.0;  // control periods that are due but did not run yet
};

}  // namespace boresight::sim
