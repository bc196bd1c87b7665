// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orientation/mounting.h"
#include "core/orientation/orientation.h"

#include <optional>
#include <vector>

// What iron near the sensor does to its heading, as a function of the true heading ψ of the beam:
//
//     reading = ψ + constant + a1 sin ψ + b1 cos ψ + a2 sin 2ψ + b2 cos 2ψ      (of a sensor that counts clockwise)
//
// The first harmonic is hard iron, the second soft iron that turns with the sensor (the coefficients B, C and D, E of
// compass adjusters; A is the constant). A swing cannot tell the constant from the offset of north: it is 0 until
// something that knows north, the Sun say, has been seen.
//
// Headings are less what the firmware adds for a declination, so they count from magnetic north, in the sensor's own
// sense; north is then that of the magnetic compass, and the declination of the place is added to it
// (withNorthMoved()), never to a heading that may count backwards. Pure values.
namespace boresight::calibration {

// Which way the sensor's angle grows when the mount turns clockwise, seen from above.
using AzimuthSense = orientation::Sense;

// An arc of true headings, clockwise from `from` to `to` (the whole circle where these are the same), where something
// steers the needle that no harmonic describes.
struct UnreliableSector
{
    Angle from;
    Angle to;
    Angle residual;  // the largest of its middle residuals

    [[nodiscard]] Angle width() const;
    [[nodiscard]] bool contains(Angle heading) const { return (heading - from).wrapped360() <= width(); }
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
    // Of what the constant is taken to be: from the swing, or from what told north since. Not known of a typed curve.
    std::optional<Angle> constantSigma;
    std::optional<Angle> elevation;  // of the boom while it was swung; the curve holds there
    std::vector<UnreliableSector> unreliable;

    // Of a sensor that counts clockwise; without the constant.
    [[nodiscard]] Angle deviation(Angle heading) const;
    // What the sensor says while the beam points to this true heading; and back.
    [[nodiscard]] orientation::SensorHeading reading(Angle heading) const;
    [[nodiscard]] Angle corrected(orientation::SensorHeading reading) const;

    [[nodiscard]] bool isReliable(Angle heading) const;
    // Of what the curve does not tell with the boom elsewhere; 0 if its own elevation is not known.
    [[nodiscard]] Angle sigmaAt(Angle otherElevation) const;
    [[nodiscard]] Angle firstAmplitude() const;
    [[nodiscard]] Angle secondAmplitude() const;
    // Only then has each reading one heading: the curve falls nowhere nearly as fast as the heading grows.
    [[nodiscard]] bool isInvertible() const;

    // The same readings after true north was found elsewhere: what was heading ψ is really ψ + correction.
    [[nodiscard]] DeviationCurve withNorthMoved(Angle correction) const;

    bool operator==(const DeviationCurve&) const = default;
};

}  // namespace boresight::calibration
