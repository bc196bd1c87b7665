// SPDX-License-Identifier: GPL-3.0-or-later
// Sun and Moon, points and the pointing model from them; Apply, Undo and Redo.
#include "tests/core/north/calibration_sun.h"
#include "tests/fakes/text_of.h"

#include <QDir>
#include <QTemporaryDir>

namespace boresight {
namespace {

using namespace boresight::literals;
using ephemeris::Body;

TEST(CalibrationPoints, FollowsTheSunAndSaysSo)
{
    CalibrationRig rig;
    setHour(rig, 8.0);
    follow(rig);
    const StationStatus status = rig.control.status();
    EXPECT_EQ(QStringLiteral("Sun"), status.targetText);
    EXPECT_EQ(QStringLiteral("operator"), status.commander.name);
    ASSERT_TRUE(status.actual);
    EXPECT_LT(apart(*status.actual, rig.status().bodies.at(0).direction), 0.02);
    EXPECT_TRUE(rig.status().following);
    EXPECT_FALSE(rig.status().warning.isEmpty());
    ASSERT_FALSE(status.alarms.empty());
    EXPECT_TRUE(status.alarms.front().remedy.contains(QStringLiteral("solar filter")));
    // Ten minutes later the beam is still on the Sun.
    rig.run(Seconds(600.0));
    EXPECT_LT(apart(*rig.control.status().actual, rig.status().bodies.at(0).direction), 0.02);
    ASSERT_TRUE(rig.ask(request::Hold{}));
    rig.run(Seconds(0.5));
    EXPECT_FALSE(rig.status().following);
}

TEST(CalibrationPoints, OverTheTopOnlyWhereTheElevationReachesIt)
{
    CalibrationRig upright;
    setHour(upright, 8.0);
    upright.run(Seconds(1.0));
    EXPECT_TRUE(upright.status().bodies.at(0).obstacle.isEmpty());
    EXPECT_TRUE(upright.status().bodies.at(0).obstacleOverTheTop.contains(QStringLiteral("over the top")));
    const AxisPosition before = upright.axes();
    EXPECT_FALSE(upright.ask(request::FollowBody{.body = Body::Sun, .overTheTop = true}));
    upright.run(Seconds(5.0));
    EXPECT_LT(abs(upright.axes().azimuth - before.azimuth), 0.01_deg);

    // The limits of operation count like the travel, also when they are set during tracking.
    CalibrationRig rig({}, profileOverTheTop());
    setHour(rig, 8.0);
    follow(rig, Body::Sun, true);
    EXPECT_GT(rig.axes().elevation, 90_deg);
    EXPECT_LT(apart(*rig.control.status().actual, rig.status().bodies.at(0).direction), 0.02);
    profile::Profile lower = rig.profile;
    lower.limits.elevation.max = 100_deg;
    rig.setProfile(lower);
    rig.run(Seconds(10.0));
    EXPECT_FALSE(rig.status().following);
    EXPECT_EQ(StationState::Hold, rig.state());
}

TEST(CalibrationPoints, TheSunIsRefusedWhereTheProfileKeepsAwayFromIt)
{
    profile::Profile profile = calibratedProfile();
    profile.sun.keepAway = profile::KeepAway::On;
    CalibrationRig rig({}, profile);
    setHour(rig, 8.0);
    rig.run(Seconds(1.0));
    const auto refused = rig.ask(request::FollowBody{.body = Body::Sun});
    ASSERT_FALSE(refused);
    EXPECT_NE(std::string::npos, textOf(refused.error()).find("sun.keep_away"));
}

TEST(CalibrationPoints, WhatIsDownOrUnknownIsRefused)
{
    CalibrationRig rig;
    setHour(rig, 23.0);
    EXPECT_FALSE(rig.ask(request::FollowBody{.body = Body::Sun}));
    rig.run(Seconds(0.5));
    EXPECT_FALSE(rig.status().bodies.at(0).isUp);
    ASSERT_TRUE(rig.status().bodies.at(0).nextRise);
    EXPECT_NEAR(3.9, Seconds(*rig.status().bodies.at(0).nextRise - rig.clock.utc()).count() / 3600.0, 0.2);
    EXPECT_FALSE(rig.ask(request::TakePoint{}));
    profile::Profile profile = calibratedProfile();
    profile.site.known = false;
    CalibrationRig nowhere({}, profile);
    EXPECT_FALSE(nowhere.ask(request::FollowBody{.body = Body::Sun}));
    nowhere.run(Seconds(0.5));
    EXPECT_FALSE(nowhere.status().noSite.isEmpty());
    EXPECT_TRUE(nowhere.status().bodies.empty());
}

TEST(CalibrationPoints, OnePointTellsNorth)
{
    SwungRig rig;
    takeSun(rig, 8.0);
    ASSERT_TRUE(rig.apply());
    EXPECT_NEAR(37.4, rig.terms().azimuthOffset.degrees(), 1.0);  // this includes the effect of the tilt
    EXPECT_LT(apart(rig.beam(), rig.status().bodies.at(0).direction), 0.3);
}

// The largest error of the beam on the path of the Sun over the day.
double worstOnItsWay(CalibrationRig& rig)
{
    const pointing::PointingModel found(rig.terms());
    double worst = 0.0;
    for (double hour = 4.5; hour < 18.0; hour += 0.5) {
        setHour(rig, hour);
        rig.tick();
        rig.run(Seconds(0.3));
        const SkyPointing sun = rig.status().bodies.at(0).direction;
        worst = std::max(worst, apart(rig.model.toSky(found.toAxes(sun).axes), sun));
    }
    return worst;
}

// The whole procedure of an operator: first the compass, then the Sun of one day.
TEST(CalibrationPoints, ASwingThenThreeAndSixSunsMakeTheModel)
{
    CalibrationRig rig;
    rig.goTo(200.0, 30.0);
    ASSERT_TRUE(rig.ask(request::StartSwing{.rate = 3_deg_s, .headings = 0}));
    rig.runOut();
    ASSERT_TRUE(rig.apply());
    for (const double hour : {5.0, 9.0, 15.0}) {
        takeSun(rig, hour);
    }
    ASSERT_TRUE(rig.apply());
    EXPECT_NEAR(37.4, rig.terms().azimuthOffset.degrees(), 0.15);
    EXPECT_LT(worstOnItsWay(rig), 0.15);
    for (const double hour : {7.0, 11.0, 17.5}) {
        takeSun(rig, hour);
    }
    ASSERT_EQ(6U, rig.status().points.size());
    const Angle sigma = rig.status().proposal->terms.at(0).sigma.value();
    ASSERT_TRUE(rig.apply());
    EXPECT_NEAR(rig.truth.terms.tiltNorth.degrees(), rig.terms().tiltNorth.degrees(), 0.1);
    EXPECT_NEAR(rig.truth.terms.tiltEast.degrees(), rig.terms().tiltEast.degrees(), 0.1);
    EXPECT_LT(worstOnItsWay(rig), 0.05);
    // The arc of the Sun cannot fully separate north from collimation. The sigma shows this.
    EXPECT_LT(abs(rig.terms().azimuthOffset - rig.truth.terms.azimuthOffset), 2.0 * sigma);
    EXPECT_NEAR(37.4, rig.terms().azimuthOffset.degrees(), 0.15);
    RecordProperty("north_error", std::to_string(rig.terms().azimuthOffset.degrees() - 37.4));
}

// With one of three or two of six points taken with the boom past the zenith, the terms are right by themselves, on any
// day.
// REQ-CALIBRATION-17a
TEST(CalibrationPoints, SunsFromBothSidesTellTheTermsApart)
{
    CalibrationRig rig({}, profileOverTheTop());
    rig.goTo(200.0, 30.0);
    ASSERT_TRUE(rig.ask(request::StartSwing{.rate = 3_deg_s, .headings = 0}));
    rig.runOut();
    ASSERT_TRUE(rig.apply());
    takeSun(rig, 6.0);
    takeSun(rig, 9.0, true);
    EXPECT_GT(rig.axes().elevation, 90_deg);
    EXPECT_TRUE(rig.status().overTheTop);
    takeSun(rig, 15.0);
    EXPECT_FALSE(rig.status().overTheTop);
    ASSERT_TRUE(rig.apply());
    EXPECT_NEAR(37.4, rig.terms().azimuthOffset.degrees(), 0.15);
    EXPECT_LT(worstOnItsWay(rig), 0.15);
    takeSun(rig, 7.0);
    takeSun(rig, 11.0);
    takeSun(rig, 14.0, true);
    ASSERT_EQ(6U, rig.status().points.size());
    ASSERT_TRUE(rig.apply());
    EXPECT_NEAR(37.4, rig.terms().azimuthOffset.degrees(), 0.05);
    EXPECT_NEAR(0.3, rig.terms().collimation.degrees(), 0.05);
    EXPECT_NEAR(rig.truth.terms.tiltNorth.degrees(), rig.terms().tiltNorth.degrees(), 0.1);
    EXPECT_NEAR(rig.truth.terms.tiltEast.degrees(), rig.terms().tiltEast.degrees(), 0.1);
    EXPECT_LT(worstOnItsWay(rig), 0.05);
}

// REQ-NORTH-38: Only Apply puts a result into effect, and Apply moves nothing. It is refused for a result that the
// operator has not seen, and while a client's target is tracked. Undo and Redo restore exactly the earlier profile.
// Terms that are typed into the profile move nothing either. While a direction is tracked, or is the target of a slew,
// both Apply and typed terms are refused. A calibration that is running ends.
TEST(CalibrationPoints, ApplyMovesNothing)
{
    SwungRig rig;
    takeSun(rig, 8.0);
    const AxisPosition before = rig.axes();
    const SkyPointing sky = *rig.control.status().actual;
    ASSERT_TRUE(rig.apply());
    rig.run(Seconds(5.0));
    EXPECT_LT(abs(rig.axes().azimuth - before.azimuth), 0.01_deg);
    EXPECT_LT(abs(rig.axes().elevation - before.elevation), 0.01_deg);
    EXPECT_GT(apart(sky, *rig.control.status().actual), 0.5);  // only the displayed true direction changes
    EXPECT_FALSE(rig.status().following);
    EXPECT_FALSE(rig.control.status().trim);
}

TEST(CalibrationPoints, ApplyWaitsWhileAClientIsFollowed)
{
    SwungRig rig;
    takeSun(rig, 8.0);
    ASSERT_TRUE(rig.ask(request::GiveAuthority{}));
    ASSERT_TRUE(rig.point(120.0, 30.0, kClient));
    rig.run(Seconds(2.0));
    EXPECT_FALSE(rig.apply());
    ASSERT_TRUE(rig.ask(request::Hold{}));
    EXPECT_TRUE(rig.apply());
}

// REQ-NORTH-38
TEST(CalibrationPoints, UndoAndRedoGiveExactlyWhatWas)
{
    QTemporaryDir folder;
    CalibrationRig rig({}, calibratedProfile(), folder.path());
    profile::Profile first = rig.profile;
    first.pointing.azimuthOffset = 36_deg;
    first.sensor.mounting.azimuthOffset = 12.345678_deg;
    rig.setProfile(first);
    rig.goTo(200.0, 30.0);
    ASSERT_TRUE(rig.ask(request::StartSwing{.rate = 3_deg_s, .headings = 0}));
    rig.runOut();
    ASSERT_TRUE(rig.apply());
    const profile::Profile second = rig.profile;
    EXPECT_NE(first, second);
    takeSun(rig, 8.0);
    ASSERT_TRUE(rig.apply());
    const profile::Profile third = rig.profile;
    EXPECT_NE(second.sensor, third.sensor);  // the compass offset changes with north

    ASSERT_TRUE(rig.ask(request::UndoCalibration{}));
    EXPECT_EQ(second, rig.profile);
    ASSERT_TRUE(rig.ask(request::UndoCalibration{}));
    EXPECT_EQ(first, rig.profile);
    EXPECT_FALSE(rig.ask(request::UndoCalibration{}));
    ASSERT_TRUE(rig.ask(request::RedoCalibration{}));
    ASSERT_TRUE(rig.ask(request::RedoCalibration{}));
    EXPECT_EQ(third, rig.profile);
    EXPECT_FALSE(rig.ask(request::RedoCalibration{}));

    // The same after a restart.
    rig.file->flush();
    CalibrationRig again({}, rig.profile, folder.path());
    again.tick();
    ASSERT_EQ(2U, again.status().history.size());
    EXPECT_TRUE(again.status().history.front().inForce);
    EXPECT_TRUE(again.status().canUndo);
    ASSERT_TRUE(again.ask(request::UndoCalibration{}));
    EXPECT_NEAR(second.pointing.azimuthOffset.degrees(), again.terms().azimuthOffset.degrees(), 2e-9);
}

// Story: a swing made beside a car stayed proposed until another result replaced it.
TEST(CalibrationPoints, WhatIsDiscardedIsProposedNoMoreAndChangesNothing)
{
    SwungRig rig;
    takeSun(rig, 8.0);
    const profile::Profile before = rig.profile;
    ASSERT_TRUE(rig.status().proposal);
    const std::uint64_t number = rig.status().proposal->number;
    EXPECT_FALSE(rig.ask(request::DiscardCalibration{number - 1})) << "another was looked at";
    ASSERT_TRUE(rig.status().proposal);
    ASSERT_TRUE(rig.ask(request::DiscardCalibration{number}));
    rig.run(Seconds(2.0));
    EXPECT_FALSE(rig.status().proposal);
    EXPECT_EQ(before, rig.profile);
    EXPECT_EQ(rig.status().points.size(), 1U);
    EXPECT_FALSE(rig.ask(request::ApplyCalibration{number}));
    EXPECT_FALSE(rig.ask(request::DiscardCalibration{number}));
    ASSERT_TRUE(rig.ask(request::ProposeTerms{{.azimuthOffset = 12_deg}}));
    ASSERT_TRUE(rig.apply());
    ASSERT_TRUE(rig.ask(request::UndoCalibration{}));
    EXPECT_FALSE(rig.status().proposal) << "Undo is no new point";
    takeSun(rig, 10.0);
    EXPECT_TRUE(rig.status().proposal) << "what comes later is";
}

// Story: 37.4° was applied, then 50° and a collimation were typed. Undo and Redo lost both without a report.
// REQ-NORTH-38
// REQ-NORTH-38f: Undo and Redo lose nothing that was typed since. They are refused and name the change, and the history
// shows the change too. They warn if the entry belongs to another drive or site. After them the points are proposed
// again if they lead to another result. Apply is refused if the result is invalid with settings that wait for
// Reconnect, and while another bus waits for Reconnect.
TEST(CalibrationPoints, UndoAndRedoLoseNothingThatWasTypedSince)
{
    SwungRig rig;
    takeSun(rig, 8.0);
    ASSERT_TRUE(rig.apply());
    const profile::Profile applied = rig.profile;
    profile::Profile typed = applied;
    typed.pointing.azimuthOffset = 50_deg;
    typed.pointing.collimation = 0.7_deg;
    rig.setProfile(typed);
    const auto undone = rig.ask(request::UndoCalibration{});
    ASSERT_FALSE(undone);
    EXPECT_NE(std::string::npos, textOf(undone.error()).find("50.00°")) << textOf(undone.error());
    EXPECT_EQ(typed, rig.profile);
    rig.setProfile(applied);
    ASSERT_TRUE(rig.ask(request::UndoCalibration{}));
    rig.setProfile(typed);
    EXPECT_FALSE(rig.ask(request::RedoCalibration{}));
    EXPECT_EQ(typed, rig.profile);
}

// Settings that wait for Reconnect are saved, too: Apply must not make a profile that cannot be loaded again.
// REQ-NORTH-38f
TEST(CalibrationPoints, WhatMakesNoSenseWithWhatWaitsIsRefused)
{
    SwungRig rig;
    takeSun(rig, 8.0);
    profile::Profile waiting = rig.profile;
    waiting.park.azimuth = 3000_deg;  // beyond any travel
    rig.inForce.apply(waiting);
    EXPECT_FALSE(rig.apply());
    rig.inForce.apply(rig.profile);
    EXPECT_TRUE(rig.apply());
}

// Story: the drive lost its wrap between two points. No warning said that the points before and after the operator's
// answer may not fit together.
// REQ-NORTH-38h
TEST(CalibrationPoints, PointsFromBeforeTheTurnWasToldWarn)
{
    CalibrationRig rig;
    rig.goTo(100.0, 45.0);
    ASSERT_TRUE(rig.ask(request::TakeKnownPoint{.truth = {.azimuth = 10_deg, .elevation = 45_deg}, .label = {}}));
    rig.run(Seconds(0.5));
    ASSERT_TRUE(rig.status().proposal);
    EXPECT_TRUE(rig.status().proposal->warnings.empty());
    rig.azimuth.silent = rig.elevation.silent = true;
    rig.run(Seconds(0.5));
    rig.azimuth.home = moteus::HomeState::Rotor;
    rig.azimuth.position = std::remainder(rig.azimuth.position, 0.01);
    rig.azimuth.mode = rig.elevation.mode = moteus::Mode::Stopped;
    rig.azimuth.silent = rig.elevation.silent = false;
    drive_check::DriveFacts restarted = rig.factsOf(Axis::Azimuth);
    restarted.bootedAt = rig.clock.now();
    rig.learn(Axis::Azimuth, restarted);
    rig.run(Seconds(2.0));
    ASSERT_TRUE(rig.control.isTurnAsked(Axis::Azimuth));
    ASSERT_TRUE(rig.status().proposal);
    ASSERT_EQ(1U, rig.status().proposal->warnings.size());
    EXPECT_TRUE(rig.status().proposal->warnings.front().contains(QStringLiteral("entered the cable wrap again")));
}

// REQ-NORTH-38
TEST(CalibrationPoints, WhatWasNotSeenIsNotApplied)
{
    SwungRig rig;
    takeSun(rig, 8.0);
    rig.tick();
    const std::uint64_t seen = rig.status().proposal->number;
    ASSERT_TRUE(rig.ask(request::TakeKnownPoint{.truth = {.azimuth = 10_deg, .elevation = 30_deg}, .label = {}}));
    EXPECT_FALSE(rig.ask(request::ApplyCalibration{seen}));
    ASSERT_TRUE(rig.ask(request::DropPoint{1}));
    EXPECT_FALSE(rig.ask(request::DropPoint{1}));
    EXPECT_TRUE(rig.apply());
}

// REQ-NORTH-38b
TEST(CalibrationPoints, AHistoryThatCannotBeReadIsNotWrittenOver)
{
    QTemporaryDir folder;
    CalibrationRig first({}, calibratedProfile(), folder.path());
    first.goTo(200.0, 30.0);
    ASSERT_TRUE(first.ask(request::TakeKnownPoint{.truth = {.azimuth = 10_deg, .elevation = 30_deg}, .label = {}}));
    ASSERT_TRUE(first.apply());
    first.file->flush();
    QFile file(first.file->path());
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("rubbish");
    file.close();
    CalibrationRig second({}, calibratedProfile(), folder.path());
    second.run(Seconds(1.0));
    EXPECT_FALSE(second.status().historyProblem.isEmpty());
    ASSERT_TRUE(second.ask(request::DropAllPoints{}));
    ASSERT_TRUE(second.ask(request::TakeKnownPoint{.truth = {.azimuth = 10_deg, .elevation = 30_deg}, .label = {}}));
    ASSERT_TRUE(second.apply());
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_EQ(QByteArray("rubbish"), file.readAll());
}

}  // namespace
}  // namespace boresight
