// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/tuning_status.h"
#include "core/tracking/axis_profile.h"

#include <functional>
#include <optional>
#include <vector>

// What a tuning run does, piece by piece: small ways and low rates about the place where it begins, and back there at
// the end. Pure; mechanical angles of one axis.
namespace boresight {

struct TuningLeg
{
    std::optional<Angle> place{};  // go there; else move at the rate
    // At this time of the leg, where the set-point is `from` the beginning of the run.
    std::function<AngularRate(Seconds, Angle from)> rate{};
    Seconds time{0.0};          // of the rate, or how long to stay at the place
    Seconds record{0.0};        // record from here on
    std::optional<int> part{};  // of what is recorded; empty: nothing is
};

// The largest way from the beginning, and whether it needs room on both sides.
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
// `way`: 1 upwards, -1 downwards, for a run that needs room on one side.
[[nodiscard]] std::vector<TuningLeg> legsOf(TuningRun run, Angle begin, double way,
                                            const tracking::MotionLimits& limits);
// The largest way of the set-point from the beginning.
[[nodiscard]] Angle farthestOf(const std::vector<TuningLeg>& legs, Angle begin);
// As long as the limits make it.
[[nodiscard]] Seconds durationOf(const std::vector<TuningLeg>& legs, const tracking::MotionLimits& limits);

}  // namespace boresight
