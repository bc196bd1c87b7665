// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>

// The trajectory generator inside a moteus: from the present control position and velocity to a target that may
// itself move, with bounded velocity and acceleration (bang-bang, no jerk limit). It works in the device's own control
// periods, because what it does near a target depends on them: it sees the distance in whole counts of 2^-16 turns, and
// drops the target once that is under ten periods of travel. Pure; turns of the output, seconds.
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

    // As many control periods as have begun by the end of `dt`.
    void step(double dt, const TrajectoryLimits& limits, const PositionBounds& bounds);

    // The frame of reference moved by `offset`: control position and target move along.
    void shift(double offset);
    // The set-point is dragged to a position (limited slip, output position set); velocity as it was.
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
    double m_owed = 0.0;  // control periods that are due
};

}  // namespace boresight::sim
