// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>

// The fastest motion of one axis under a speed and an acceleration limit: accelerate, cruise, brake. Closed formulas,
// exact within a tick, so a target is reached without oscillation. Plain numbers in radians and seconds: the arithmetic
// below AxisSetpoints, which uses types for quantities. Pure.
namespace boresight::tracking {

struct MotionState
{
    double position = 0.0;
    double rate = 0.0;
};

// Motion with constant acceleration.
struct Segment
{
    double duration = 0.0;
    MotionState start;
    double acceleration = 0.0;

    [[nodiscard]] MotionState at(double time) const;
    [[nodiscard]] MotionState end() const { return at(duration); }
    [[nodiscard]] bool atRest() const { return start.rate == 0.0 && acceleration == 0.0; }
};

// The segments of one tick, one after the other. At most four: change of speed, constant speed, change to the rate of
// the target, motion with the target.
class Path
{
public:
    void add(const Segment& segment) { m_segments.at(m_count++) = segment; }
    [[nodiscard]] std::span<const Segment> segments() const { return std::span(m_segments).first(m_count); }

private:
    std::array<Segment, 4> m_segments;
    std::size_t m_count = 0;
};

struct MotionBounds
{
    double speed = 0.0;
    double acceleration = 0.0;
};

// The first `duration` seconds of the fastest way to a target that is at `target.position` now and moves at
// `target.rate` (at most the speed limit). Once reached, the target is followed exactly.
[[nodiscard]] Path approach(const MotionState& now, const MotionState& target, const MotionBounds& bounds,
                            double duration);

// The first `duration` seconds of the fastest change to a rate. The rate is then kept.
[[nodiscard]] Path changeRate(const MotionState& now, double rate, double acceleration, double duration);

// The time of the fastest way to stand still at `position`.
[[nodiscard]] double restTime(const MotionState& now, double position, const MotionBounds& bounds);

// The speed limit with which the way to `position` takes `time`, at most that of `bounds`. Never so small that the way
// would not end.
[[nodiscard]] double speedForRestTime(const MotionState& now, double position, const MotionBounds& bounds, double time);

// Where the fastest stop would end.
[[nodiscard]] double stopPosition(const MotionState& state, double acceleration);

}  // namespace boresight::tracking
