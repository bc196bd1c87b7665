// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/model_in_force.h"

#include "tests/core/north/north_rig.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

using namespace boresight::literals;
using calibration::indexOf;
using calibration::Term;

// A record with a tilt, as a swing finds it.
calibration::CalibrationRecord swingRecord()
{
    calibration::CalibrationRecord record{.title = QStringLiteral("North from the compass swing")};
    record.terms.after = {.azimuthOffset = 37.4_deg, .tiltNorth = 0.5_deg, .tiltEast = -0.3_deg};
    record.sigmas[indexOf(Term::AzimuthOffset)] = 2_deg;
    record.sigmas[indexOf(Term::TiltNorth)] = 0.05_deg;
    record.sigmas[indexOf(Term::TiltEast)] = 0.06_deg;
    record.sensor.emplace();
    return record;
}

// A record with a north that the Sun gave after `swing`.
calibration::CalibrationRecord sunRecord(const calibration::CalibrationRecord& swing)
{
    calibration::CalibrationRecord record{.title = QStringLiteral("Pointing model from 1 point")};
    record.terms.after = swing.terms.after;
    record.terms.after.azimuthOffset = 38.1_deg;
    record.sigmas = swing.sigmas;
    record.sigmas[indexOf(Term::AzimuthOffset)] = 0.04_deg;
    record.points = {{.axes = {.azimuth = 100_deg, .elevation = 30_deg}, .truth = {}}};
    return record;
}

calibration::Estimate knownTilt(const NorthRig& rig)
{
    return rig.model.known().of(Term::TiltNorth).value_or(calibration::Estimate{});
}

TEST(ModelInForce, ATermKeepsItsSigmaAsLongAsItKeepsItsValue)
{
    NorthRig rig;
    rig.apply(swingRecord());
    EXPECT_EQ(2_deg, rig.model.sheet().sigmas[indexOf(Term::AzimuthOffset)]);
    rig.profile.pointing.azimuthOffset += 1_deg;
    rig.inForce.apply(rig.profile);
    EXPECT_FALSE(rig.model.sheet().sigmas[indexOf(Term::AzimuthOffset)]);
    EXPECT_EQ(0.05_deg, rig.model.sheet().sigmas[indexOf(Term::TiltNorth)]);
}

TEST(ModelInForce, OnlyASwingIsKnownBeforeThePoints)
{
    NorthRig rig;
    const Angle usual = knownTilt(rig).sigma;
    rig.apply(swingRecord());
    EXPECT_EQ(0.5_deg, knownTilt(rig).value);
    EXPECT_EQ(0.05_deg, knownTilt(rig).sigma);
    static_cast<void>(rig.file.undo());
    EXPECT_EQ(usual, knownTilt(rig).sigma);

    calibration::CalibrationRecord typed = swingRecord();
    typed.sensor.reset();
    rig.apply(typed);
    EXPECT_EQ(usual, knownTilt(rig).sigma);
}

TEST(ModelInForce, PointsHaveGivenNorthButNotTheTiltThatTheyOnlyHeld)
{
    NorthRig rig;
    rig.apply(swingRecord());
    EXPECT_FALSE(rig.model.toldByPoints()[indexOf(Term::AzimuthOffset)]) << "a compass knows it only by its box";
    rig.apply(sunRecord(swingRecord()));
    EXPECT_EQ(0.04_deg, rig.model.toldByPoints()[indexOf(Term::AzimuthOffset)]);
    EXPECT_FALSE(rig.model.toldByPoints()[indexOf(Term::TiltNorth)]);
}

TEST(ModelInForce, AnotherDriveHasAnotherModel)
{
    NorthRig rig;
    rig.apply(swingRecord());
    rig.apply(sunRecord(swingRecord()));
    EXPECT_TRUE(rig.model.otherMount().isEmpty());
    drive_check::DriveFacts other = rig.factsOf(Axis::Azimuth);
    other.uuid = QStringLiteral("a0000000-0000-0000-0000-000000000009");
    rig.learn(Axis::Azimuth, other);
    ASSERT_TRUE(rig.mount.update());
    EXPECT_EQ(
        "The pointing model in force (\"Pointing model from 1 point\", 2026-11-21) was applied with another drive",
        rig.model.otherMount().toStdString());
    EXPECT_FALSE(rig.model.toldByPoints()[indexOf(Term::AzimuthOffset)]);
    EXPECT_NE(0.05_deg, knownTilt(rig).sigma);
}

TEST(ModelInForce, WhatWasTypedSinceIsNamed)
{
    NorthRig rig;
    EXPECT_TRUE(rig.model.changedSince().isEmpty()) << "nothing was applied";
    rig.apply(swingRecord());
    EXPECT_TRUE(rig.model.changedSince().isEmpty());
    rig.profile.pointing.collimation = 0.3_deg;
    rig.inForce.apply(rig.profile);
    EXPECT_TRUE(rig.model.changedSince().contains(QStringLiteral("collimation")))
        << rig.model.changedSince().toStdString();
    rig.profile.site.known = true;
    rig.inForce.apply(rig.profile);
    EXPECT_TRUE(rig.model.otherMount().isEmpty()) << "what was typed is of no entry";
}

}  // namespace
}  // namespace boresight
