// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the report of a swing about the zero of elevation, and how a swing treats a north and a tilt that points have
// determined.
#include "core/cross_check/sensor_curve.h"
#include "tests/core/north/calibration_swing.h"

namespace boresight {
namespace {

// A profile that says the sensor box is tilted by 5°, on a mount without this tilt.
profile::Profile askew()
{
    profile::Profile profile = calibratedProfile();
    profile.sensor.mounting.elevationOffset = 5_deg;
    return profile;
}

// Points all round, which determine every term better than a sensor.
void applyLandmarks(CalibrationRig& rig)
{
    for (const double azimuth : {20.0, 140.0, 260.0}) {
        for (const double elevation : {20.0, 60.0}) {
            rig.goTo(azimuth, elevation);
            ASSERT_TRUE(rig.ask(request::TakeKnownPoint{.truth = rig.beam(), .label = {}}));
        }
    }
    rig.tick();
    ASSERT_TRUE(rig.apply());
}

void sweep(CalibrationRig& rig)
{
    rig.goTo(200.0, 30.0);
    ASSERT_TRUE(rig.ask(kSweep));
    rig.runOut();
    ASSERT_TRUE(rig.status().proposal) << rig.status().progress.outcome.toStdString();
}

// The zero of elevation that a swing proposes.
Angle swungZero(CalibrationRig& rig)
{
    sweep(rig);
    return rig.status().proposal ? rig.status().proposal->terms.at(1).proposed : Angle{};
}

// Only points determine the zero better than a sensor. A sigma from a text or an earlier swing does not count.
TEST(CalibrationSwing, AZeroThatNoPointHasToldIsNoneThatIsKnown)
{
    CalibrationRig rig({}, askew());
    calibration::TermSheet sheet{.terms = {.elevationOffset = 0.2_deg}};
    sheet.sigmas[calibration::indexOf(calibration::Term::ElevationOffset)] = 0.01_deg;
    ASSERT_TRUE(
        rig.ask(request::ImportTerms{.name = QStringLiteral("roof.terms"), .text = calibration::toText(sheet)}));
    rig.tick();
    ASSERT_TRUE(rig.apply());
    EXPECT_NEAR(5.0, swungZero(rig).degrees(), 0.5);
}

TEST(CalibrationSwing, AZeroThatPointsHaveToldStays)
{
    CalibrationRig rig({}, askew());
    applyLandmarks(rig);
    ASSERT_LT(abs(rig.terms().elevationOffset), 0.5_deg);
    EXPECT_EQ(rig.terms().elevationOffset, swungZero(rig));
}

// Story: after ten points a swing proposed a north with twenty times the error, and the curve could not be applied
// without this north.
// REQ-NORTH-36b
TEST(CalibrationSwing, ANorthThatPointsHaveToldStaysAndTheCurveCanBeHad)
{
    CalibrationRig rig;
    applyLandmarks(rig);
    const pointing::PointingTerms told = rig.terms();
    ASSERT_LT(std::abs(northError(rig)), 0.5);
    rig.goTo(200.0, 30.0);
    ASSERT_TRUE(rig.ask(kSweep));
    rig.runOut();
    EXPECT_TRUE(rig.status().progress.outcome.contains(QStringLiteral("North stays")))
        << rig.status().progress.outcome.toStdString();
    ASSERT_TRUE(rig.apply());
    EXPECT_EQ(told.azimuthOffset, rig.terms().azimuthOffset);
    EXPECT_TRUE(wasSwung(rig.profile.sensor));
    EXPECT_LT(rig.profile.sensor.deviation.sigma, 0.5_deg) << "as well as the points know north";
    rig.run(Seconds(0.5));
    EXPECT_TRUE(rig.status().history.front().change.contains(QStringLiteral("curve of the sensor")));
    // A second swing does not lose what the points have determined.
    ASSERT_TRUE(rig.ask(kSweep));
    rig.runOut();
    EXPECT_TRUE(rig.status().progress.outcome.contains(QStringLiteral("North stays")));
}

// Story: a swing found the tilt within ±0.05°, and three points then gave ±0.045°. The next swing took this value as
// known better than its own. So its tilt, which was as good and newer, could not be applied.
// REQ-NORTH-36b
TEST(CalibrationSwing, ATiltThatPointsHaveOnlyHeldIsNoneThatTheyHaveTold)
{
    CalibrationRig rig;
    ASSERT_NO_FATAL_FAILURE(sweep(rig));
    ASSERT_TRUE(rig.apply());
    const calibration::TermSheet swung = rig.status().sheet;
    rig.truth.terms.tiltNorth += 0.15_deg;  // the mast leans more, so the points lead to another tilt
    rig.model = pointing::PointingModel(rig.truth.terms);
    for (const double azimuth : {20.0, 140.0, 260.0}) {
        rig.goTo(azimuth, 20.0 + azimuth / 10.0);
        ASSERT_TRUE(rig.ask(request::TakeKnownPoint{.truth = rig.beam(), .label = {}}));
    }
    rig.tick();
    ASSERT_TRUE(rig.apply());
    const calibration::TermSheet held = rig.status().sheet;
    const std::size_t tilt = calibration::indexOf(calibration::Term::TiltNorth);
    ASSERT_LT(held.sigmas[tilt], swung.sigmas[tilt]);
    ASSERT_GT(*held.sigmas[tilt], *swung.sigmas[tilt] / 2.0);
    ASSERT_NO_FATAL_FAILURE(sweep(rig));
    const QString outcome = rig.status().progress.outcome;
    EXPECT_FALSE(outcome.contains(QStringLiteral("tilt stays"))) << outcome.toStdString();
    EXPECT_TRUE(outcome.contains(QStringLiteral("North stays"))) << outcome.toStdString();
    EXPECT_NE(held.terms.tiltNorth, rig.status().proposal->terms.at(tilt).proposed);
    EXPECT_TRUE(rig.status().proposal->terms.at(tilt).isOn);
}

// The mast stands elsewhere: points from the old site do not count.
TEST(CalibrationSwing, ANorthOfAnotherSiteDoesNotStay)
{
    CalibrationRig rig;
    applyLandmarks(rig);
    profile::Profile moved = rig.profile;
    moved.site.longitude = 20_deg;
    rig.setProfile(moved);
    rig.goTo(200.0, 30.0);
    ASSERT_TRUE(rig.ask(kSweep));
    rig.runOut();
    EXPECT_FALSE(rig.status().progress.outcome.contains(QStringLiteral("stays")))
        << rig.status().progress.outcome.toStdString();
}

}  // namespace
}  // namespace boresight
