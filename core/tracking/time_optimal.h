// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

// The quickest motion of one axis under a speed and an acceleration limit: accelerate, cruise, brake. Closed forms,
// exact inside a tick, so a target is met and not hunted. Bare numbers in radians and seconds: this is the arithmetic
// beneath AxisProfile, which speaks in quantities. Pure.
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

struct MotionBounds
{
    double speed = 0.0;
    double acceleration = 0.0;
};

// The first `duration` seconds of the quickest way onto a target that now is at `target.position` and moves on with
// `target.rate` (at most the speed bound). Once met, the target is followed exactly.
[[nodiscard]] std::vector<Segment> approach(const MotionState& now, const MotionState& target,
                                            const MotionBounds& bounds, double duration);

// The first `duration` seconds of the quickest change to a rate, which is then kept.
[[nodiscard]] std::vector<Segment> changeRate(const MotionState& now, double rate, double acceleration,
                                              double duration);

// How long the quickest way takes to rest at `position`.
[[nodiscard]] double restTime(const MotionState& now, double position, const MotionBounds& bounds);

// The speed bound with which the way to rest at `position` takes `time`, at most that of `bounds`. Never so small that
// it never ends.
[[nodiscard]] double speedForRestTime(const MotionState& now, double position, const MotionBounds& bounds, double time);

// Where the quickest stop would come to rest.
[[nodiscard]] double stopPosition(const MotionState& state, double acceleration);

}  // namespace boresight::tracking
