// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/deviation_curve.h"

#include "core/calibration/fit_words.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace boresight::calibration {
namespace {

constexpr int kDeviationCurveRounds = 60;  // bisection alone would reduce an error of a radian to 1e-18
constexpr double kExact = 1e-14;           // rad
constexpr double kSteepest = 0.9;          // of the slope -1 at which two headings give the same reading
constexpr int kSlopes = 360;  // number of tested slopes: between two of them the slope changes by less than 0.001
constexpr Angle kUnseenIron = Angle::fromDegrees(2.0);  // a first harmonic may be small by chance
constexpr Angle kSlack = Angle::fromDegrees(1e-6);

Angle amplitude(Angle sine, Angle cosine)
{
    return Angle::fromRadians(std::hypot(sine.radians(), cosine.radians()));
}

// How fast the reading of a clockwise sensor grows with the heading.
double slopeAt(const DeviationCurve& curve, double psi)
{
    return 1.0 + curve.a1.radians() * std::cos(psi) - curve.b1.radians() * std::sin(psi) +
           2.0 * (curve.a2.radians() * std::cos(2.0 * psi) - curve.b2.radians() * std::sin(2.0 * psi));
}

}  // namespace

Angle UnreliableSector::width() const
{
    const Angle width = (to - from).wrapped360();
    return width < kSlack ? Angle::fromTurns(1.0) : width;
}

bool UnreliableSector::overlaps(Angle first, Angle last) const
{
    return contains(first) || (from - first).wrapped360() <= last - first;
}

Angle DeviationCurve::deviation(Angle heading) const
{
    const double psi = heading.radians();
    return a1 * std::sin(psi) + b1 * std::cos(psi) + a2 * std::sin(2.0 * psi) + b2 * std::cos(2.0 * psi);
}

orientation::SensorHeading DeviationCurve::reading(Angle heading) const
{
    const Angle clockwise = heading + constant + deviation(heading);
    return orientation::SensorHeading::folded(sense == AzimuthSense::Clockwise ? clockwise : -clockwise);
}

// Newton's method. Every step stays inside a bracket and narrows it.
Angle DeviationCurve::corrected(orientation::SensorHeading reading) const
{
    const Angle target = (sense == AzimuthSense::Clockwise ? reading.angle() : -reading.angle()) - constant;
    const Angle reach = firstAmplitude() + secondAmplitude() + kSlack;
    Angle low = target - reach;
    Angle high = target + reach;
    Angle heading = target;
    for (int round = 0; round < kDeviationCurveRounds; ++round) {
        const Angle excess = heading + deviation(heading) - target;
        if (std::abs(excess.radians()) < kExact) {
            break;
        }
        (excess > Angle{} ? high : low) = heading;
        const Angle step = heading - excess / slopeAt(*this, heading.radians());
        heading = step > low && step < high ? step : (low + high) / 2.0;
    }
    return heading.wrapped360();
}

bool DeviationCurve::isReliable(Angle heading) const
{
    return isReliable(heading, heading);
}

bool DeviationCurve::isReliable(Angle first, Angle last) const
{
    return std::none_of(unreliable.begin(), unreliable.end(),
                        [&](const UnreliableSector& sector) { return sector.overlaps(first, last); });
}

Angle DeviationCurve::firstAmplitude() const
{
    return amplitude(a1, b1);
}

Angle DeviationCurve::secondAmplitude() const
{
    return amplitude(a2, b2);
}

bool DeviationCurve::isInvertible() const
{
    for (int i = 0; i < kSlopes; ++i) {
        if (slopeAt(*this, 2.0 * std::numbers::pi * i / kSlopes) < 1.0 - kSteepest) {
            return false;
        }
    }
    return true;
}

// Hard iron is a vector that turns up and down with the box. The swing sees only the part across the needle at its own
// elevation. The three parts of the vector are equally likely to be large. So another elevation adds the size of one
// part (from the first harmonic) times the way that the box has turned.
Angle DeviationCurve::sigmaAt(Angle otherElevation) const
{
    if (!elevation) {
        return {};
    }
    const Angle iron = hypot(firstAmplitude() / std::numbers::sqrt2, kUnseenIron);
    return iron * std::abs(2.0 * std::sin((otherElevation - *elevation).radians() / 2.0));
}

DeviationCurve DeviationCurve::withNorthMoved(Angle correction) const
{
    const double once = correction.radians();
    const double twice = 2.0 * once;
    DeviationCurve moved = *this;
    moved.constant = constant - correction;
    moved.a1 = a1 * std::cos(once) + b1 * std::sin(once);
    moved.b1 = b1 * std::cos(once) - a1 * std::sin(once);
    moved.a2 = a2 * std::cos(twice) + b2 * std::sin(twice);
    moved.b2 = b2 * std::cos(twice) - a2 * std::sin(twice);
    for (UnreliableSector& sector : moved.unreliable) {
        sector.from = (sector.from + correction).wrapped360();
        sector.to = (sector.to + correction).wrapped360();
    }
    return moved;
}

}  // namespace boresight::calibration
