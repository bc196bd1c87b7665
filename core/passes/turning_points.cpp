// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/passes/turning_points.h"

#include <algorithm>
#include <cmath>

namespace boresight::passes {

namespace {

constexpr double kTimeStep = 1e-4;  // s, to which a crossing is found
constexpr int kMostTurns = 60;      // halving a week down to kTimeStep needs 33

double straightBetween(double a, double valueA, double b, double valueB)
{
    const double share = valueA / (valueA - valueB);
    return a + std::clamp(share, 0.01, 0.99) * (b - a);
}

// Uses the rates of SGP4, which differ slightly from the derivative of its positions. Regula falsi in the Illinois
// form: an end that stays twice gets half its weight.
std::optional<SkyMoment> whereTheClimbTurns(SkyTrack& track, const SkyMoment& a, const SkyMoment& b)
{
    constexpr double kNear = 0.2;  // s: turningPoint() continues from there
    double low = a.seconds;
    double high = b.seconds;
    double lowClimb = a.climb;
    double highClimb = b.climb;
    int side = 0;  // the end that was moved last
    std::optional<SkyMoment> here = a;
    for (int i = 0; here && i < kMostTurns; ++i) {
        const double before = here->seconds;
        here = track.at(straightBetween(low, lowClimb, high, highClimb));
        if (!here || std::abs(here->seconds - before) < kNear || high - low < kNear) {
            break;
        }
        const int moved = here->climbs() == a.climbs() ? -1 : 1;
        (moved < 0 ? low : high) = here->seconds;
        (moved < 0 ? lowClimb : highClimb) = here->climb;
        if (moved == side) {
            (moved < 0 ? highClimb : lowClimb) *= 0.5;
        }
        side = moved;
    }
    return here;
}

}  // namespace

// Newton's steps while they stay between the ends, otherwise bisection.
std::optional<SkyMoment> crossing(SkyTrack& track, const SkyMoment& a, const SkyMoment& b)
{
    double low = a.seconds;
    double high = b.seconds;
    std::optional<SkyMoment> here = track.at(straightBetween(low, a.above, high, b.above));
    for (int i = 0; here && i < kMostTurns; ++i) {
        (here->isUp() == a.isUp() ? low : high) = here->seconds;
        const double newton = here->seconds - here->above / here->aboveRate;
        const bool isBetween = newton > low && newton < high;  // false for a rate of 0
        const double next = isBetween ? newton : 0.5 * (low + high);
        if ((isBetween && std::abs(newton - here->seconds) < kTimeStep) || high - low < kTimeStep) {
            break;
        }
        here = track.at(next);
    }
    return here;
}

// The vertex of the parabola through three positions. The rates of SGP4 are wrong by up to 1e-5 km/s, which would shift
// the result by minutes for a geostationary satellite.
std::optional<SkyMoment> turningPoint(SkyTrack& track, const SkyMoment& a, const SkyMoment& b, Limits limits)
{
    constexpr double kArc = 5e-4;  // of the mean anomaly, rad: half a second in a low orbit
    constexpr int kMostParabolas = 6;
    std::optional<SkyMoment> here = whereTheClimbTurns(track, a, b);
    for (int i = 0; here && i < kMostParabolas; ++i) {
        const double width = kArc / here->motion;
        const auto before = track.at(here->seconds - width);
        const auto after = track.at(here->seconds + width);
        if (!before || !after) {
            return std::nullopt;
        }
        const double slope = after->sineElevation - before->sineElevation;
        const double bend = after->sineElevation - 2.0 * here->sineElevation + before->sineElevation;
        const double shift = -0.5 * width * slope / bend;
        if (!(std::abs(shift) > kTimeStep && bend != 0.0)) {
            break;
        }
        const double target = std::clamp(here->seconds + shift, limits.from, limits.to);
        const bool isNear = std::abs(target - here->seconds) < width;
        here = track.at(target);
        if (isNear) {
            break;
        }
    }
    return here;
}

}  // namespace boresight::passes
