// SPDX-License-Identifier: GPL-3.0-or-later
// The whole procedure on a mount without any calibration: swing, tilt, three and six points of the Sun, and the sensor
// corrected by the north of the Sun.
#include "core/calibration/axis_tilt.h"
#include "core/calibration/compass_swing.h"
#include "core/calibration/pointing_fit.h"
#include "core/calibration/sensor_offset.h"
#include "tests/fakes/sun_points.h"
#include "tests/fakes/swung_mount.h"

#include <gtest/gtest.h>

#include <cmath>

namespace boresight::calibration {
namespace {

using fakes::SunDay;
using fakes::SwungMount;
using orientation::SensorHeading;
using pointing::PointingTerms;

constexpr int kMounts = 30;
constexpr double kCentring = 0.02;  // degrees
constexpr double kBoom = 30.0;      // elevation of the swing

// The sensor is on the boom: a collimation of the beam does not affect it.
SwungMount sensorOn(const PointingTerms& hidden, std::mt19937_64& random)
{
    SwungMount mount = fakes::randomMount(random, fakes::Needle::Iron);
    mount.terms = hidden;
    mount.terms.collimation = {};
    return mount;
}

struct Found
{
    CompassSwing swing;
    PointingTerms terms;  // after the swing
    TermKnowledge known;
};

Found afterSwing(const SwungMount& mount, std::mt19937_64& random)
{
    const fakes::Swung swung = fakes::swing(mount, random, {.elevation = kBoom});
    const auto swing = fitCompassSwing(swung.samples);
    EXPECT_TRUE(swing.has_value());
    const auto tilt = fitAxisTilt(swung.levels, swing->north);
    EXPECT_TRUE(tilt.has_value());
    Found found{.swing = *swing, .terms = {}, .known = TermKnowledge::usual()};
    found.terms.azimuthOffset = swing->north.value;
    found.terms.elevationOffset = tilt->elevationOffset.value;
    found.terms.tiltNorth = tilt->north.value;
    found.terms.tiltEast = tilt->east.value;
    found.known.of(Term::ElevationOffset) = tilt->elevationOffset;
    found.known.of(Term::TiltNorth) = tilt->north;
    found.known.of(Term::TiltEast) = tilt->east;
    return found;
}

// The offset from a mount that stands still, with its sensor corrected by the curve of the swing and the north of the
// Sun.
Angle offsetBySensor(const SwungMount& mount, const DeviationCurve& curve, double azimuth)
{
    const std::vector<SensorReading> still(
        20, {.heading = SensorHeading::folded(Angle::fromDegrees(mount.heading(azimuth, kBoom))),
             .axisAzimuth = Angle::fromDegrees(azimuth),
             .axisRate = {},
             .motorCurrent = 0.0,
             .systemCalibration = 3,
             .magnetometerCalibration = 3});
    const auto offset = sensorOffset(still, {}, curve);
    EXPECT_TRUE(offset.has_value());
    return offset->offset.value;
}

// REQ-CALIBRATION-21: The whole procedure is consistent: swing, tilt, points of the Sun, and the sensor corrected by
// the Sun.
TEST(Procedure, FromNothingToTheSun)
{
    std::mt19937_64 random(37);
    int three = 0;
    int six = 0;
    int north = 0;
    int tilt = 0;
    for (int i = 0; i < kMounts; ++i) {
        const PointingTerms hidden = fakes::randomHidden(random);
        const SwungMount mount = sensorOn(hidden, random);
        const Found found = afterSwing(mount, random);
        const Angle off = (found.terms.azimuthOffset - hidden.azimuthOffset).wrapped180();
        EXPECT_LT(abs(off), found.swing.north.sigma * 3.0);

        const SunDay day = fakes::randomDay(random);
        const auto fit3 = fitPointing(fakes::sunPoints(hidden, day, 3, kCentring, random), found.terms, found.known);
        const auto fit6 = fitPointing(fakes::sunPoints(hidden, day, 6, kCentring, random), found.terms, found.known);
        ASSERT_TRUE(fit3 && fit6);
        three += fakes::worstOnArc(hidden, fit3->terms, day) < 0.15 ? 1 : 0;
        six += fakes::worstOnArc(hidden, fit6->terms, day) < 0.05 ? 1 : 0;
        north += fakes::northError(hidden, fit3->terms) < 0.15 && fakes::northError(hidden, fit6->terms) < 0.05 ? 1 : 0;
        const SkyOffset leaning{fit6->terms.tiltNorth - hidden.tiltNorth, fit6->terms.tiltEast - hidden.tiltEast};
        tilt += leaning.size() < 0.1_deg ? 1 : 0;

        const Angle offset = fit6->terms.azimuthOffset;
        const DeviationCurve curve = found.swing.curve.withNorthMoved(offset - found.swing.north.value);
        const double azimuth = mount.steelFrom + 120.0;  // away from steel
        EXPECT_NEAR((offsetBySensor(mount, curve, azimuth) - offset).wrapped180().degrees(), 0.0, 1.0);
    }
    EXPECT_GE(three, kMounts - 1);
    EXPECT_GE(six, kMounts - 3);
    EXPECT_GE(north, kMounts - 1);
    EXPECT_GE(tilt, kMounts - 1);
}

}  // namespace
}  // namespace boresight::calibration
