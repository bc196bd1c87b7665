// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orientation/mounting.h"
#include "core/orientation/orientation.h"

#include <optional>
#include <vector>

// The deviation that iron near the sensor causes, as a function of the true heading ψ of the beam:
//
//     reading = ψ + constant + a1 sin ψ + b1 cos ψ + a2 sin 2ψ + b2 cos 2ψ      (of a sensor that counts clockwise)
//
// The first harmonic is hard iron, the second soft iron that turns with the sensor (the coefficients B, C and D, E of
// compass adjusters; A is the constant). A swing cannot distinguish the constant from the offset of north. The constant
// is 0 until something that knows north was measured, for example the Sun.
//
// The declination that the firmware adds is removed from the headings. So headings count from magnetic north in the
// sensor's own sense, and north is that of the magnetic compass. The local declination is added to north
// (withNorthMoved()), not to a heading, because a heading may count counter-clockwise. Pure values.
namespace boresight::calibration {

// The direction in which the sensor's angle grows, seen from above, when the mount turns clockwise.
using AzimuthSense = orientation::Sense;

// An arc of true headings, clockwise from `from` to `to` (the whole circle if both are equal), in which iron disturbs
// the needle in a way that no harmonic describes.
struct UnreliableSector
{
    Angle from;
    Angle to;
    Angle residual;  // the largest of its median residuals

    [[nodiscard]] Angle width() const;
    [[nodiscard]] bool contains(Angle heading) const { return (heading - from).wrapped360() <= width(); }
    // Whether a part of the arc lies between these headings, clockwise from the first to the second.
    [[nodiscard]] bool overlaps(Angle first, Angle last) const;
    bool operator==(const UnreliableSector&) const = default;
};

struct DeviationCurve
{
    AzimuthSense sense = AzimuthSense::Clockwise;
    Angle constant;
    Angle a1;
    Angle b1;
    Angle a2;
    Angle b2;
    Angle scatter;  // rms of a single reading about the curve
    // Sigma of the constant: from the swing, or from what gave north since. Empty for a typed curve.
    std::optional<Angle> constantSigma;
    std::optional<Angle> elevation;  // of the boom during the swing; the curve is valid there
    std::vector<UnreliableSector> unreliable;

    // For a clockwise sensor, without the constant.
    [[nodiscard]] Angle deviation(Angle heading) const;
    // The sensor's reading while the beam points to this true heading, and the inverse.
    [[nodiscard]] orientation::SensorHeading reading(Angle heading) const;
    [[nodiscard]] Angle corrected(orientation::SensorHeading reading) const;

    [[nodiscard]] bool isReliable(Angle heading) const;
    // The same for all headings between these, clockwise from the first to the second.
    [[nodiscard]] bool isReliable(Angle first, Angle last) const;
    // The additional uncertainty at another elevation of the boom. 0 if the elevation of the curve is unknown.
    [[nodiscard]] Angle sigmaAt(Angle otherElevation) const;
    [[nodiscard]] Angle firstAmplitude() const;
    [[nodiscard]] Angle secondAmplitude() const;
    // Each reading has exactly one heading. That holds while the curve never falls nearly as fast as the heading grows.
    [[nodiscard]] bool isInvertible() const;

    // The curve for the same readings after true north was corrected: the heading ψ becomes ψ + correction.
    [[nodiscard]] DeviationCurve withNorthMoved(Angle correction) const;

    bool operator==(const DeviationCurve&) const = default;
};

}  // namespace boresight::calibration
