// SPDX-License-Identifier: GPL-3.0-or-later
// The average of the sensor on a mount that stands still and whose north is hidden.
#include "tests/core/north/calibration_sun.h"
#include "tests/core/north/calibration_swing.h"
#include "tests/fakes/text_of.h"

namespace boresight {
namespace {

// REQ-NORTH-35b (CalibrationSensor.*)
TEST(CalibrationSensor, TheStillMountTellsNorthAsWellAsOneHeadingCan)
{
    CalibrationRig rig;
    ASSERT_TRUE(rig.ask(request::MeasureSensorOffset{}));
    rig.runOut(Seconds(60.0));
    ASSERT_TRUE(rig.status().sensorOffset) << rig.status().progress.outcome.toStdString();
    ASSERT_TRUE(rig.apply());
    EXPECT_LT(std::abs(northError(rig)), 12.0);
    EXPECT_GT(rig.status().sensorOffset->offset.sigma.degrees(), 3.0);
}

bool hasLogged(const CalibrationRig& rig, const QString& line)
{
    return std::ranges::any_of(rig.log.since(0, EventLog::kCapacity), [&](const LogEntry& entry) {
        return entry.source == QStringLiteral("operator") && entry.text == line;
    });
}

// REQ-NORTH-963: An unreliable result, such as a north from beside steel, is applied only if the operator overrides
// each doubt explicitly. The log names the override and the doubts.
TEST(CalibrationSensor, AnUnreliableNorthNeedsTheOperatorsOverride)
{
    profile::Profile profile = calibratedProfile();
    profile.sensor.deviation.unreliable = {{.from = 0_deg, .to = 360_deg}};
    CalibrationRig rig({}, profile);
    ASSERT_TRUE(rig.ask(request::MeasureSensorOffset{}));
    rig.runOut(Seconds(60.0));
    ASSERT_TRUE(rig.status().proposal) << rig.status().progress.outcome.toStdString();
    const CalibrationProposal proposal = *rig.status().proposal;
    ASSERT_EQ(proposal.doubts.size(), 1U);
    const pointing::PointingTerms before = rig.terms();
    const auto refused = rig.apply();
    ASSERT_FALSE(refused);
    EXPECT_EQ(textOf(refused.error()),
              "This result is unreliable. " + proposal.doubts[0].toStdString() + " To use it, press Apply anyway.");
    EXPECT_EQ(rig.terms(), before);
    ASSERT_TRUE(rig.status().proposal) << "it still waits";

    EXPECT_FALSE(rig.ask(request::ApplyCalibration{.proposal = proposal.number + 1, .overridesDoubts = true}))
        << "of another proposal";
    ASSERT_TRUE(rig.ask(request::ApplyCalibration{.proposal = proposal.number, .overridesDoubts = true}));
    EXPECT_NE(rig.terms(), before);
    EXPECT_TRUE(hasLogged(rig, QStringLiteral("overrode this warning by Apply anyway: ") + proposal.doubts[0]));
}

// REQ-NORTH-962: Applying a proposal that has warnings is logged with each of them.
TEST(CalibrationSensor, ApplyingInSpiteOfAWarningIsLogged)
{
    CalibrationRig rig;
    ASSERT_TRUE(rig.ask(request::MeasureSensorOffset{}));
    rig.runOut(Seconds(60.0));
    ASSERT_TRUE(rig.status().proposal);
    const std::vector<QString> warnings = rig.status().proposal->warnings;
    ASSERT_FALSE(warnings.empty()) << "one heading gives a poor north";
    ASSERT_TRUE(rig.apply());
    for (const QString& warning : warnings) {
        EXPECT_TRUE(hasLogged(rig, QStringLiteral("applied despite this warning: ") + warning))
            << warning.toStdString();
    }
}

// Story: the average was measured with a mounting of 0°, then 90° was typed. The old north was still proposed, under a
// new number.
// REQ-NORTH-38g: A result of the sensor is withdrawn when the settings of the sensor or the declination change.
TEST(CalibrationSensor, WhatWasFoundWithOtherSettingsIsNotProposedAnyMore)
{
    CalibrationRig rig;
    const auto measured = [&rig] {
        EXPECT_TRUE(rig.ask(request::MeasureSensorOffset{}));
        rig.runOut(Seconds(60.0));
        rig.run(Seconds(0.5));
        return rig.status().proposal.has_value();
    };
    ASSERT_TRUE(measured());
    profile::Profile other = rig.profile;
    other.jog.slow = 0.3_deg_s;
    rig.setProfile(other);
    rig.run(Seconds(0.5));
    EXPECT_TRUE(rig.status().proposal);
    other.sensor.stillCurrent = 2.0;  // does not change the meaning of a reading
    rig.setProfile(other);
    rig.run(Seconds(0.5));
    EXPECT_TRUE(rig.status().proposal);
    other.sensor.mounting.azimuthOffset = 90_deg;
    rig.setProfile(other);
    rig.run(Seconds(0.5));
    EXPECT_FALSE(rig.status().proposal);
    EXPECT_FALSE(rig.status().sensorOffset);
    ASSERT_TRUE(measured());
    rig.truth.declination += 1.0;  // another magnetic model was read
    rig.run(Seconds(3.0));
    EXPECT_FALSE(rig.status().proposal);
}

// REQ-NORTH-36a
TEST(CalibrationSensor, TheProfileSaysHowMuchCurrentIsTooMuch)
{
    for (const auto& [limit, accepted] : {std::pair(1.5, false), std::pair(2.5, true)}) {
        profile::Profile profile = calibratedProfile();
        profile.sensor.stillCurrent = limit;
        CalibrationRig rig({}, profile);
        rig.elevation.current = -2.0;
        rig.run(Seconds(2.0));
        ASSERT_TRUE(rig.ask(request::MeasureSensorOffset{}));
        rig.runOut(Seconds(60.0));
        const std::string outcome = rig.status().progress.outcome.toStdString();
        EXPECT_EQ(accepted, rig.status().sensorOffset.has_value()) << outcome;
        EXPECT_EQ(!accepted,
                  outcome.find("Motor current 2.0 A disturbs the compass (limit 1.5 A, sensor.still_current_a)") !=
                      std::string::npos)
            << outcome;
    }
}

TEST(CalibrationSensor, AMountThatMovesTellsNothing)
{
    CalibrationRig rig;
    ASSERT_TRUE(rig.ask(request::MeasureSensorOffset{}));
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 180_deg, .elevation = 30_deg}}));
    rig.runOut(Seconds(60.0));
    EXPECT_TRUE(rig.status().progress.failed);
    EXPECT_FALSE(rig.status().proposal);
}

// Story: while the Sun was tracked the average ran for its 20 s and was refused only then.
TEST(CalibrationSensor, IsNotAveragedWhileABodyIsFollowed)
{
    SwungRig rig;
    setHour(rig, 8.0);
    follow(rig);
    const auto refused = rig.ask(request::MeasureSensorOffset{});
    ASSERT_FALSE(refused);
    EXPECT_EQ("The mount tracks the Sun. Press Hold first.", textOf(refused.error()));
    ASSERT_TRUE(rig.ask(request::Hold{}));
    rig.run(Seconds(3.0));
    EXPECT_TRUE(rig.ask(request::MeasureSensorOffset{}));
}

TEST(CalibrationSensor, IsNotAveragedWhileTheMountMoves)
{
    CalibrationRig rig;
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 180_deg, .elevation = 30_deg}}));
    rig.run(Seconds(2.0));
    const auto refused = rig.ask(request::MeasureSensorOffset{});
    ASSERT_FALSE(refused);
    EXPECT_NE(std::string::npos, textOf(refused.error()).find("stands still"));
}

// Both requests come in the same tick: the follower has not yet seen that the mount was sent elsewhere.
TEST(CalibrationSensor, AnAverageRightAfterTheBodyWasLeftIsNoFault)
{
    SwungRig rig;
    setHour(rig, 8.0);
    follow(rig);
    ASSERT_TRUE(rig.control.request(request::PointAxes{{.azimuth = 200_deg, .elevation = 30_deg}}, kOperator));
    const auto measures = rig.desk.carryOut(request::MeasureSensorOffset{});
    EXPECT_TRUE(measures || textOf(measures.error()).find("follows the") == std::string::npos);
    rig.run(Seconds(1.0));
    EXPECT_FALSE(rig.status().following);
}

}  // namespace
}  // namespace boresight
