// SPDX-License-Identifier: GPL-3.0-or-later
// The swing of the compass and the average of the still sensor, on a mount whose north is hidden.
#include "core/station/sensor_curve.h"
#include "tests/core/station/calibration_rig.h"

#include <algorithm>

namespace boresight {
namespace {

using namespace boresight::literals;

double northError(const CalibrationRig& rig)
{
    return (rig.terms().azimuthOffset - rig.truth.terms.azimuthOffset).wrapped180().degrees();
}

const request::StartSwing kSweep{.rate = 3_deg_s, .headings = 0};

// A mount in the middle of its swing.
void swingHalfWay(CalibrationRig& rig)
{
    rig.goTo(200.0, 30.0);
    ASSERT_TRUE(rig.ask(kSweep));
    rig.run(Seconds(80.0));
    ASSERT_EQ(CalibrationRun::Swing, rig.status().progress.run);
    ASSERT_TRUE(rig.desk.moves());
    StationStatus status = rig.control.status();
    rig.desk.fill(status);
    EXPECT_EQ(StationState::Calibrate, status.state);
}

TEST(CalibrationSwing, FindsNorthAndTheTilt)
{
    CalibrationRig rig;
    rig.goTo(200.0, 30.0);
    ASSERT_TRUE(rig.ask(kSweep));
    rig.runOut();
    const CalibrationStatus& status = rig.status();
    ASSERT_FALSE(status.progress.failed) << status.progress.outcome.toStdString();
    ASSERT_TRUE(status.swing);
    ASSERT_TRUE(status.proposal);
    EXPECT_GT(status.swing->samples.size(), 200U);

    ASSERT_TRUE(rig.apply());
    const double sigma = status.swing->fit.north.sigma.degrees();
    EXPECT_LT(std::abs(northError(rig)), 2.0);
    EXPECT_LT(std::abs(northError(rig)), 2.0 * sigma);
    EXPECT_LT(sigma, 3.0);
    EXPECT_NEAR(rig.truth.terms.tiltNorth.degrees(), rig.terms().tiltNorth.degrees(), 0.15);
    EXPECT_NEAR(rig.truth.terms.tiltEast.degrees(), rig.terms().tiltEast.degrees(), 0.15);
}

TEST(CalibrationSwing, StopsAtHeadingsFindNorthToo)
{
    CalibrationRig rig;
    rig.goTo(100.0, 30.0);
    ASSERT_TRUE(rig.ask(request::StartSwing{.rate = 3_deg_s, .headings = 16}));
    rig.runOut();
    ASSERT_TRUE(rig.status().proposal) << rig.status().progress.outcome.toStdString();
    ASSERT_TRUE(rig.apply());
    EXPECT_LT(std::abs(northError(rig)), 2.0);
}

// A still mount whose compass was swung knows its deviation, and how well.
TEST(CalibrationSwing, KeepsHowFarItIsToBeBelieved)
{
    CalibrationRig rig;
    rig.goTo(200.0, 30.0);
    ASSERT_TRUE(rig.ask(kSweep));
    rig.runOut();
    const calibration::DeviationCurve found = rig.status().swing->fit.curve;
    EXPECT_TRUE(rig.status().proposal->text.contains(QStringLiteral("where the elevation axis shows 0°")));
    ASSERT_TRUE(rig.apply());
    EXPECT_EQ(rig.profile.sensor.deviation.sigma, found.constantSigma);
    EXPECT_NEAR(rig.profile.sensor.deviation.elevation.degrees(), 30.0, 0.1);
    const auto offsetSigma = [&rig] {
        rig.run(Seconds(5.0));
        EXPECT_TRUE(rig.ask(request::MeasureSensorOffset{}));
        rig.runOut(Seconds(60.0));
        EXPECT_TRUE(rig.status().sensorOffset) << rig.status().progress.outcome.toStdString();
        return rig.status().sensorOffset->offset.sigma;
    };
    const Angle there = offsetSigma();
    EXPECT_GT(there, found.constantSigma);
    EXPECT_LT(there, *found.constantSigma + 1_deg);
    rig.goTo(200.0, 70.0);
    EXPECT_GT(offsetSigma(), there + 1_deg) << "another elevation";
    ASSERT_TRUE(rig.ask(request::UndoCalibration{}));
    EXPECT_EQ(rig.profile.sensor.deviation, profile::CompassDeviation());
}

// The sensor's later readings are true: its curve came into force with north.
TEST(CalibrationSwing, CorrectsTheSensor)
{
    CalibrationRig rig;
    rig.goTo(200.0, 30.0);
    ASSERT_TRUE(rig.ask(kSweep));
    rig.runOut();
    ASSERT_TRUE(rig.apply());
    const auto curve = curveOf(rig.profile.sensor, Angle::fromDegrees(rig.truth.declination));
    for (double heading = 0.0; heading < 360.0; heading += 15.0) {
        const double magnetic = heading - rig.truth.declination;
        const double said = magnetic + 8.0 * sine(magnetic - 50.0) + 3.0 * sine(2.0 * (magnetic - 20.0)) + 5.07;
        const Angle corrected = curve.corrected(orientation::SensorHeading::folded(Angle::fromDegrees(said)));
        EXPECT_LT(std::abs((corrected - Angle::fromDegrees(heading)).wrapped180().degrees()), 2.0) << heading;
    }
}

TEST(CalibrationSwing, TellsWhereItTurnsAndHowLongBeforeItStarts)
{
    CalibrationRig rig;
    rig.goTo(200.0, 30.0);
    ASSERT_TRUE(rig.ask(request::PlanSwing{.rate = 3_deg_s, .headings = 0}));
    rig.tick();
    const SwingPlan plan = rig.status().swingPlan;
    EXPECT_TRUE(plan.obstacle.isEmpty()) << plan.obstacle.toStdString();
    EXPECT_GE(plan.azimuth.min, rig.control.region().ranges().azimuth.min);
    EXPECT_LE(plan.azimuth.max, rig.control.region().ranges().azimuth.max);
    EXPECT_GT((plan.azimuth.max - plan.azimuth.min).degrees(), 350.0);

    ASSERT_TRUE(rig.ask(kSweep));
    const SteadyTime began = rig.clock.now();
    Angle lowest = rig.axes().azimuth;
    Angle highest = lowest;
    while (rig.desk.moves() && Seconds(rig.clock.now() - began) < Seconds(900.0)) {
        rig.tick();
        lowest = std::min(lowest, rig.axes().azimuth);
        highest = std::max(highest, rig.axes().azimuth);
    }
    EXPECT_NEAR(plan.duration.count(), Seconds(rig.clock.now() - began).count(), 0.1 * plan.duration.count());
    EXPECT_GE(lowest, plan.azimuth.min - 0.1_deg);
    EXPECT_LE(highest, plan.azimuth.max + 0.1_deg);
}

// The cable's limit, not the travel's end, is where a swing turns back.
TEST(CalibrationSwing, StaysWithinTheLimitsOfOperation)
{
    profile::Profile profile = calibratedProfile();
    profile.limits.azimuth = {.min = 20_deg, .max = 300_deg};
    profile.park.azimuth = 100_deg;
    CalibrationRig rig({}, profile);
    rig.goTo(200.0, 30.0);
    ASSERT_TRUE(rig.ask(kSweep));
    while (rig.desk.moves()) {
        rig.tick();
        ASSERT_GE(rig.axes().azimuth, 20_deg);
        ASSERT_LE(rig.axes().azimuth, 300_deg);
    }
    ASSERT_TRUE(rig.status().swing) << rig.status().progress.outcome.toStdString();
    ASSERT_TRUE(rig.apply());
    EXPECT_LT(std::abs(northError(rig)), 4.0);
}

TEST(CalibrationSwing, StopEndsItAtOnceAndLatches)
{
    CalibrationRig rig;
    swingHalfWay(rig);
    ASSERT_TRUE(rig.ask(request::Stop{}));
    const AxisPosition at = rig.axes();
    rig.run(Seconds(3.0));
    EXPECT_EQ(CalibrationRun::None, rig.status().progress.run);
    EXPECT_TRUE(rig.status().progress.failed);
    EXPECT_FALSE(rig.status().proposal);
    EXPECT_EQ(StationState::Stopped, rig.state());
    EXPECT_TRUE(rig.status().progress.outcome.startsWith(QStringLiteral("STOP ended it")))
        << rig.status().progress.outcome.toStdString();
    EXPECT_LT(abs(rig.axes().azimuth - at.azimuth), 3_deg);
    ASSERT_TRUE(rig.ask(request::ResetStop{}));
    const AxisPosition rest = rig.axes();
    rig.run(Seconds(5.0));
    EXPECT_EQ(rest, rig.axes());
}

TEST(CalibrationSwing, EndsWithAnyOtherMotion)
{
    for (const Request& other :
         {Request(request::Hold{}), Request(request::Jog{{.azimuth = 1_deg_s, .elevation = {}}}),
          Request(request::Step{.azimuth = 1_deg, .elevation = {}}), Request(request::EndCalibration{})}) {
        CalibrationRig rig;
        swingHalfWay(rig);
        ASSERT_TRUE(rig.ask(other));
        rig.run(Seconds(0.1));
        EXPECT_EQ(CalibrationRun::None, rig.status().progress.run);
        EXPECT_FALSE(rig.status().progress.outcome.isEmpty());
        EXPECT_FALSE(rig.desk.moves());
    }
}

TEST(CalibrationSwing, ASensorThatIsLostEndsItAndHolds)
{
    CalibrationRig rig;
    swingHalfWay(rig);
    rig.speaks = false;
    rig.run(Seconds(34.0));
    EXPECT_EQ(CalibrationRun::Swing, rig.status().progress.run);
    const AxisPosition rest = rig.axes();
    rig.run(Seconds(4.0));
    EXPECT_EQ(CalibrationRun::None, rig.status().progress.run);
    EXPECT_TRUE(rig.status().progress.failed);
    EXPECT_TRUE(rig.status().progress.outcome.contains(QStringLiteral("sensor has said nothing for 3")))
        << rig.status().progress.outcome.toStdString();
    EXPECT_EQ(StationState::Hold, rig.state());
    rig.speaks = true;
    rig.run(Seconds(5.0));
    EXPECT_EQ(rest, rig.axes()) << "what has ended does not begin by itself";
}

// Story: a WiFi that was away for ten seconds cost a swing of four minutes.
TEST(CalibrationSwing, WaitsAtRestForASensorThatFallsSilent)
{
    for (const int headings : {0, 16}) {
        CalibrationRig rig;
        rig.goTo(200.0, 30.0);
        ASSERT_TRUE(rig.ask(request::StartSwing{.rate = 3_deg_s, .headings = headings}));
        rig.run(Seconds(90.0));
        rig.speaks = false;
        rig.run(Seconds(15.0));
        const AxisPosition rest = rig.axes();
        const Seconds left = rig.status().progress.left;
        EXPECT_TRUE(rig.status().progress.text.startsWith(QStringLiteral("standing still until the sensor is heard")));
        rig.run(Seconds(10.0));
        EXPECT_EQ(rest, rig.axes());
        EXPECT_EQ(left, rig.status().progress.left) << "waiting is no progress";
        rig.speaks = true;
        rig.runOut();
        ASSERT_TRUE(rig.status().proposal) << rig.status().progress.outcome.toStdString();
        ASSERT_TRUE(rig.apply());
        EXPECT_LT(std::abs(northError(rig)), 2.0);
    }
}

TEST(CalibrationSwing, StopEndsTheWaitingToo)
{
    CalibrationRig rig;
    swingHalfWay(rig);
    rig.speaks = false;
    rig.run(Seconds(12.0));
    ASSERT_TRUE(rig.ask(request::Stop{}));
    rig.run(Seconds(1.0));
    EXPECT_EQ(CalibrationRun::None, rig.status().progress.run);
    ASSERT_TRUE(rig.ask(request::ResetStop{}));
    const AxisPosition rest = rig.axes();
    rig.speaks = true;
    rig.run(Seconds(5.0));
    EXPECT_EQ(rest, rig.axes());
}

TEST(CalibrationSwing, ADriveInFaultEndsIt)
{
    CalibrationRig rig;
    swingHalfWay(rig);
    rig.azimuth.mode = moteus::Mode::Fault;
    rig.azimuth.fault = 38;
    rig.run(Seconds(1.0));
    EXPECT_EQ(StationState::Fault, rig.state());
    EXPECT_EQ(CalibrationRun::None, rig.status().progress.run);
    EXPECT_TRUE(rig.status().progress.failed);
}

TEST(CalibrationSwing, IsRefusedWithTheReason)
{
    {
        CalibrationRig rig;
        rig.speaks = false;
        rig.run(Seconds(10.0));
        EXPECT_FALSE(rig.ask(kSweep));
    }
    {
        profile::Profile profile = calibratedProfile();
        profile.sensor.source = profile::SensorSource::None;
        CalibrationRig rig({}, profile);
        const auto refused = rig.ask(kSweep);
        ASSERT_FALSE(refused);
        EXPECT_EQ(ErrorCode::NotAvailable, refused.error().code);
    }
    CalibrationRig rig;
    rig.calibration->magnetometer = 1;
    rig.run(Seconds(3.0));
    const auto refused = rig.ask(kSweep);
    ASSERT_FALSE(refused);
    EXPECT_NE(std::string::npos, refused.error().text.find("magnetometer"));
    rig.calibration->magnetometer = 3;
    rig.run(Seconds(3.0));
    ASSERT_TRUE(rig.ask(request::GiveAuthority{}));
    EXPECT_FALSE(rig.ask(kSweep));  // the clients have the control
    ASSERT_TRUE(rig.ask(request::TakeAuthority{}));
    ASSERT_TRUE(rig.ask(request::Stop{}));
    EXPECT_FALSE(rig.ask(kSweep));
    rig.run(Seconds(1.0));
    ASSERT_TRUE(rig.ask(request::ResetStop{}));
    EXPECT_FALSE(rig.ask(request::StartSwing{.rate = 20_deg_s, .headings = 0}));
    EXPECT_FALSE(rig.ask(request::StartSwing{.rate = 3_deg_s, .headings = 3}));
    EXPECT_TRUE(rig.ask(kSweep));
    EXPECT_FALSE(rig.ask(kSweep));  // it runs already
}

TEST(CalibrationSwing, AClientMayAskForNothingOfIt)
{
    CalibrationRig rig;
    EXPECT_FALSE(rig.control.request(kSweep, kClient));
}

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

// Story: measured with a mounting of 0°, 90° typed, and the north of before was still proposed, under a new number.
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
    other.sensor.mounting.azimuthOffset = 90_deg;
    rig.setProfile(other);
    rig.run(Seconds(0.5));
    EXPECT_FALSE(rig.status().proposal);
    EXPECT_FALSE(rig.status().sensorOffset);
    ASSERT_TRUE(measured());
    rig.truth.declination += 1.0;  // another model was read
    rig.run(Seconds(3.0));
    EXPECT_FALSE(rig.status().proposal);
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

// The broker's WiFi comes and goes: so much patience nobody at the mast has.
TEST(CalibrationSwing, WaitsNoLongerInAllThanOnce)
{
    CalibrationRig rig;
    swingHalfWay(rig);
    int waits = 0;
    for (; waits < 10 && rig.status().progress.run == CalibrationRun::Swing; ++waits) {
        rig.speaks = false;
        rig.run(Seconds(17.0));
        rig.speaks = true;
        rig.run(Seconds(3.0));
    }
    EXPECT_TRUE(rig.status().progress.failed);
    EXPECT_GT(waits, 1);
    EXPECT_LT(waits, 5);
}

bool warnsOfTheWait(const CalibrationRig& rig)
{
    const auto alarms = rig.control.status().alarms;
    return std::ranges::any_of(
        alarms, [](const Alarm& alarm) { return alarm.active && alarm.action.contains(QStringLiteral("BY ITSELF")); });
}

TEST(CalibrationSwing, WhoStandsAtTheMastIsToldThatItWillGoOn)
{
    CalibrationRig rig;
    swingHalfWay(rig);
    EXPECT_FALSE(warnsOfTheWait(rig));
    rig.speaks = false;
    rig.run(Seconds(12.0));
    EXPECT_TRUE(warnsOfTheWait(rig));
    rig.speaks = true;
    rig.run(Seconds(3.0));
    EXPECT_FALSE(warnsOfTheWait(rig));
    rig.speaks = false;
    rig.run(Seconds(12.0));
    EXPECT_TRUE(warnsOfTheWait(rig));
    ASSERT_TRUE(rig.ask(request::Hold{}));
    rig.run(Seconds(0.1));
    EXPECT_FALSE(warnsOfTheWait(rig));
}

// Its compass may have another calibration now: readings from before and after are of two sensors.
TEST(CalibrationSwing, ASensorThatWasRestartedEndsIt)
{
    CalibrationRig rig;
    swingHalfWay(rig);
    rig.restarts = 1;
    rig.run(Seconds(3.0));
    EXPECT_EQ(CalibrationRun::None, rig.status().progress.run);
    EXPECT_TRUE(rig.status().progress.outcome.contains(QStringLiteral("started anew")));
    EXPECT_EQ(StationState::Hold, rig.state());
    EXPECT_TRUE(rig.ask(kSweep));
}

// Without word of its calibration nobody sees a restart: what came before and after a silence may be of two compasses.
TEST(CalibrationSwing, ASilenceOfASensorThatTellsNoCalibrationIsADoubt)
{
    for (const bool tells : {true, false}) {
        CalibrationRig rig;
        if (!tells) {
            rig.calibration.reset();
        }
        swingHalfWay(rig);
        rig.speaks = false;
        rig.run(Seconds(15.0));
        rig.speaks = true;
        rig.runOut();
        ASSERT_TRUE(rig.status().proposal) << rig.status().progress.outcome.toStdString();
        const auto warnings = rig.status().proposal->warnings;
        EXPECT_EQ(!tells, std::ranges::any_of(warnings, [](const QString& warning) {
            return warning.contains(QStringLiteral("silent"));
        }));
    }
}

// Minutes of turning are not lost for a few replies.
TEST(CalibrationSwing, OutlastsAStallOfThisComputer)
{
    CalibrationRig rig;
    swingHalfWay(rig);
    rig.azimuth.mute = rig.elevation.mute = true;
    rig.run(Seconds(0.16));
    rig.azimuth.mute = rig.elevation.mute = false;
    rig.runOut();
    EXPECT_FALSE(rig.status().progress.failed) << rig.status().progress.outcome.toStdString();
    ASSERT_TRUE(rig.apply());
    EXPECT_LT(std::abs(northError(rig)), 2.0);
}

// Near the zenith the compass says nothing, over the top it says the opposite.
TEST(CalibrationSwing, IsRefusedWithTheBoomTooHigh)
{
    profile::Profile over = calibratedProfile();
    over.elevation.geometry.travel.max = 180_deg;
    over.limits.elevation.max = 180_deg;
    for (const double elevation : {80.0, 120.0}) {
        CalibrationRig rig({}, over);
        rig.goTo(200.0, elevation);
        ASSERT_NEAR(elevation, rig.axes().elevation.degrees(), 0.1);
        const auto swing = rig.ask(kSweep);
        ASSERT_FALSE(swing);
        EXPECT_NE(std::string::npos, swing.error().text.find("lower it"));
        EXPECT_FALSE(rig.ask(request::MeasureSensorOffset{}));
    }
}

TEST(CalibrationSensor, IsNotAveragedWhileTheMountMoves)
{
    CalibrationRig rig;
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 180_deg, .elevation = 30_deg}}));
    rig.run(Seconds(2.0));
    const auto refused = rig.ask(request::MeasureSensorOffset{});
    ASSERT_FALSE(refused);
    EXPECT_NE(std::string::npos, refused.error().text.find("still moves"));
}

}  // namespace
}  // namespace boresight
