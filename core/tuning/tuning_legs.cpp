// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tuning/tuning_legs.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace boresight {
namespace {

constexpr Seconds kSteady{1.0};   // the axis is taken over, and holds
constexpr Seconds kWatched{2.0};  // recorded after a step
constexpr Seconds kRampTime{4.0};
constexpr Angle kSwing = Angle::fromDegrees(0.25);
constexpr double kPartOfLimits = 0.5;  // share of the limits of motion, so that they do not cut off the wave
constexpr double kPullBack = 0.5;      // 1/s: keeps the middle of the swing in place
constexpr double kFewestPeriods = 3.0;
constexpr Seconds kShortestSwing{2.0};
constexpr Angle kBacklashLeg = Angle::fromDegrees(0.4);
constexpr int kBacklashLegs = 9;

TuningLeg stay(Angle place, Seconds time, std::optional<int> part = {})
{
    return {.place = place, .time = time, .part = part};
}

TuningLeg run(AngularRate rate, Seconds time, std::optional<int> part = {})
{
    return {.rate = [rate](Seconds, Angle) { return rate; }, .time = time, .part = part};
}

std::vector<TuningLeg> stepLegs(Angle begin, double way)
{
    return {stay(begin, kSteady), stay(begin + way * kStepSize, kWatched, 0), stay(begin, kWatched, 1)};
}

std::vector<TuningLeg> rampLegs(Angle begin, double way, const tracking::MotionLimits& limits)
{
    const AngularRate rate = way * std::min(kRampRate, kPartOfLimits * limits.speed);
    return {stay(begin, kSteady),     run(rate, kRampTime, 0), run({}, kSteady, 0),
            run(-rate, kRampTime, 1), run({}, kSteady, 1),     stay(begin, kSteady)};
}

TuningLeg swingLeg(double hertz, int part, const tracking::MotionLimits& limits)
{
    const double omega = 2.0 * std::numbers::pi * hertz;
    const double amplitude = std::min({kSwing.radians(), kPartOfLimits * limits.speed.radians() / omega,
                                       kPartOfLimits * limits.acceleration.radians() / (omega * omega)});
    const Seconds swingsIn{std::max(1.0 / hertz, 1.0)};
    return {.rate =
                [=](Seconds time, Angle from) {
                    const double wave = amplitude * omega * std::cos(omega * time.count());
                    return AngularRate::fromRadians(wave - kPullBack * from.radians());
                },
            .time = swingsIn + std::max(Seconds(kFewestPeriods / hertz), kShortestSwing),
            .record = swingsIn,
            .part = part};
}

std::vector<TuningLeg> sweepLegs(Angle begin, const tracking::MotionLimits& limits)
{
    std::vector<TuningLeg> legs{stay(begin, kSteady)};
    for (std::size_t i = 0; i < kSweepHertz.size(); ++i) {
        legs.push_back(swingLeg(kSweepHertz[i], static_cast<int>(i), limits));
    }
    legs.push_back(stay(begin, kSteady));
    return legs;
}

std::vector<TuningLeg> backlashLegs(Angle begin)
{
    const Seconds whole{kBacklashLeg.radians() / kBacklashRate.radians()};
    std::vector<TuningLeg> legs{stay(begin, kSteady)};
    for (int i = 0; i < kBacklashLegs; ++i) {
        legs.push_back(run(i % 2 == 0 ? kBacklashRate : -kBacklashRate, i == 0 ? 0.5 * whole : whole, 0));
    }
    legs.push_back(stay(begin, kSteady));
    return legs;
}

}  // namespace

TuningRoom roomFor(TuningRun run)
{
    // Half a degree more, so that an axis that overshoots does not meet a limit.
    constexpr Angle kSpare = Angle::fromDegrees(0.5);
    switch (run) {
        case TuningRun::Step:
        case TuningRun::Ramp:
            return {.way = kStepSize + kSpare};
        case TuningRun::Sweep:
        case TuningRun::Backlash:
            break;
    }
    return {.way = kSwing + kSpare, .bothSides = true};
}

std::vector<TuningLeg> legsOf(TuningRun run, Angle begin, double way, const tracking::MotionLimits& limits)
{
    switch (run) {
        case TuningRun::Step:
            return stepLegs(begin, way);
        case TuningRun::Ramp:
            return rampLegs(begin, way, limits);
        case TuningRun::Sweep:
            return sweepLegs(begin, limits);
        case TuningRun::Backlash:
            break;
    }
    return backlashLegs(begin);
}

Angle farthestOf(const std::vector<TuningLeg>& legs, Angle begin)
{
    constexpr Seconds kPace{0.02};
    Angle farthest;
    Angle from;
    for (const TuningLeg& leg : legs) {
        if (leg.place) {
            from = *leg.place - begin;
            farthest = std::max(farthest, abs(from));
            continue;
        }
        for (Seconds time{0.0}; time < leg.time; time += kPace) {
            const Seconds pace = std::min(kPace, leg.time - time);
            from += leg.rate(time + 0.5 * pace, from) * pace;
            farthest = std::max(farthest, abs(from));
        }
    }
    return farthest;
}

// The time at full speed, plus one second for acceleration, braking and the limited jerk.
Seconds durationOf(const std::vector<TuningLeg>& legs, const tracking::MotionLimits& limits)
{
    Seconds sum{0.0};
    std::optional<Angle> at;
    for (const TuningLeg& leg : legs) {
        sum += leg.time;
        if (leg.place && at) {
            sum += Seconds(abs(*leg.place - *at).radians() / limits.speed.radians() + 1.0);
        }
        at = leg.place ? leg.place : at;
    }
    return sum;
}

}  // namespace boresight
