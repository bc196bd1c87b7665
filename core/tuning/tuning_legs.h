// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/tuning_status.h"
#include "core/tracking/axis_setpoints.h"

#include <functional>
#include <optional>
#include <vector>

// The parts of a tuning run: small ways and low rates around its starting position, and the way back at the end. Pure.
// Mechanical angles of one axis.
namespace boresight {

struct TuningLeg
{
    std::optional<Angle> place{};  // go there; empty: move at `rate`
    // The rate at this time of the leg, when the set-point is at the distance `from` the start of the run.
    std::function<AngularRate(Seconds, Angle from)> rate{};
    Seconds time{0.0};          // how long to move at the rate, or to stay at the place
    Seconds record{0.0};        // recording begins at this time of the leg
    std::optional<int> part{};  // number of the recording; empty: nothing is recorded
};

// The largest distance from the start, and whether the run needs room on both sides.
struct TuningRoom
{
    Angle way;
    bool bothSides = false;
};

inline constexpr Angle kStepSize = Angle::fromDegrees(2.0);
inline constexpr AngularRate kRampRate = AngularRate::fromDegrees(0.5);
inline constexpr AngularRate kBacklashRate = AngularRate::fromDegrees(0.05);
inline constexpr std::array kSweepHertz{0.3, 0.6, 1.2, 2.4};

[[nodiscard]] TuningRoom roomFor(TuningRun run);
// `way`: 1 upwards, -1 downwards. For a run that needs room on one side.
[[nodiscard]] std::vector<TuningLeg> legsOf(TuningRun run, Angle begin, double way,
                                            const tracking::MotionLimits& limits);
// The largest distance of the set-point from the start.
[[nodiscard]] Angle farthestOf(const std::vector<TuningLeg>& legs, Angle begin);
// The duration of the run within these limits.
[[nodiscard]] Seconds durationOf(const std::vector<TuningLeg>& legs, const tracking::MotionLimits& limits);

}  // namespace boresight
