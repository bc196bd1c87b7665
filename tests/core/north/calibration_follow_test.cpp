// SPDX-License-Identifier: GPL-3.0-or-later
// Sun and Moon are tracked as long as the operator asks for it, and a change of the model moves nothing.
#include "core/alarms/catalogue.h"
#include "core/clients/station_rotator.h"
#include "core/units/angle_between.h"
#include "tests/core/north/calibration_sun.h"
#include "tests/fakes/text_of.h"

#include <algorithm>
#include <limits>

namespace boresight {
namespace {

using namespace boresight::literals;
using ephemeris::Body;

// The first time received from the network makes the computed Sun jump across the sky. The mount does not jump after
// it.
// REQ-NORTH-37b: When the computed position of a body jumps because the clock or the site was set, the mount holds and
// shows the reason. No point is taken from that body until it is tracked again.
TEST(CalibrationFollow, AClockThatIsSetMovesNothing)
{
    SwungRig rig;
    setHour(rig, 8.0);
    follow(rig);
    const AxisPosition before = rig.axes();
    rig.clock.stepUtc(std::chrono::hours(4));
    rig.run(Seconds(10.0));
    EXPECT_FALSE(rig.status().following);
    EXPECT_EQ(StationState::Hold, rig.state());
    EXPECT_LT(abs(rig.axes().azimuth - before.azimuth), 0.1_deg);
    EXPECT_LT(abs(rig.axes().elevation - before.elevation), 0.1_deg);
    EXPECT_TRUE(std::ranges::any_of(rig.log.since(0, 3), [](const LogEntry& line) {
        return line.text.contains(QStringLiteral("Was the clock or the site changed?"));
    }));
    EXPECT_FALSE(rig.ask(request::TakePoint{})) << "Story: a Sun 45° beside the beam was taken, and north moved 15°";
    const auto again = rig.ask(request::FollowBody{.body = Body::Sun});
    EXPECT_TRUE(again) << textOf(again.error());
}

// REQ-NORTH-37e: When the clock of this computer is set, also by less than the Sun needs to move visibly, the tracking
// for a calibration ends and the mount holds. No point is taken from that body until it is tracked again. Points from
// before get a warning. While the mount is pointed by the old time, no body is tracked for a calibration.
TEST(CalibrationFollow, AClockThatIsSetEndsIt)
{
    SwungRig rig;
    takeSun(rig, 8.0);
    rig.clock.setAhead(Seconds(5.0));
    rig.desk.clockWasSet();
    rig.run(Seconds(3.0));
    EXPECT_FALSE(rig.status().following);
    EXPECT_EQ(StationState::Hold, rig.state());
    EXPECT_FALSE(rig.ask(request::TakePoint{}));
    EXPECT_EQ(1U, rig.status().points.size());
    const auto lines = rig.log.since(0, EventLog::kCapacity);
    const auto isTold = [&lines](const QString& part) {
        return std::ranges::any_of(lines, [&part](const LogEntry& line) { return line.text.contains(part); });
    };
    EXPECT_TRUE(isTold(QStringLiteral("The clock of this computer was set, so tracking stopped")));
    EXPECT_TRUE(isTold(QStringLiteral("drop the points of the Sun and the Moon")));
    const auto refused = rig.ask(request::FollowBody{.body = Body::Sun});
    ASSERT_FALSE(refused);
    EXPECT_NE(std::string::npos, textOf(refused.error()).find("Press Use new time or correct the clock"));
    rig.clock.setAhead(Seconds(0.0));
    const auto again = rig.ask(request::FollowBody{.body = Body::Sun});
    EXPECT_TRUE(again) << textOf(again.error());
}

// REQ-NORTH-37e
TEST(CalibrationFollow, AClockThatIsSetHoldsNoMotionOfOthers)
{
    SwungRig rig;
    setHour(rig, 8.0);
    follow(rig);
    ASSERT_TRUE(rig.control.request(request::PointAxes{{.azimuth = 100_deg, .elevation = 30_deg}}, kOperator));
    rig.desk.clockWasSet();
    rig.run(Seconds(60.0));
    EXPECT_NEAR(100.0, rig.axes().azimuth.degrees(), 0.01);
}

// REQ-NORTH-37b
TEST(CalibrationFollow, ASecondOfTheClockIsFollowed)
{
    SwungRig rig;
    setHour(rig, 8.0);
    follow(rig);
    rig.clock.stepUtc(Seconds(5.0));
    rig.run(Seconds(10.0));
    EXPECT_TRUE(rig.status().following);
}

// Tracking would move the mount to the new north.
// REQ-NORTH-38
TEST(CalibrationFollow, TermsTypedMeanwhileAreRefused)
{
    SwungRig rig;
    setHour(rig, 8.0);
    follow(rig);
    profile::Profile typed = rig.profile;
    typed.pointing.azimuthOffset = 50_deg;
    const auto refused = rig.ask(request::ApplyProfile{typed});
    ASSERT_FALSE(refused);
    EXPECT_NE(std::string::npos, textOf(refused.error()).find("Press Hold"));
    profile::Profile other = rig.profile;
    other.park.elevation = 45_deg;
    EXPECT_TRUE(rig.ask(request::ApplyProfile{other}));  // does not concern north
    ASSERT_TRUE(rig.ask(request::Hold{}));
    EXPECT_TRUE(rig.ask(request::ApplyProfile{typed}));
}

// REQ-NORTH-38
TEST(CalibrationFollow, TermsTypedWhileAClientIsFollowedAreRefused)
{
    SwungRig rig;
    ASSERT_TRUE(rig.ask(request::GiveAuthority{}));
    ASSERT_TRUE(rig.point(120.0, 30.0, kClient));
    rig.run(Seconds(2.0));
    profile::Profile typed = rig.profile;
    typed.pointing.azimuthOffset = 50_deg;
    EXPECT_FALSE(rig.ask(request::ApplyProfile{typed}));
}

// The readings so far belong to another sensor or another mount.
// REQ-NORTH-38
TEST(CalibrationFollow, TermsTypedInMidSwingEndIt)
{
    CalibrationRig rig;
    rig.goTo(200.0, 30.0);
    ASSERT_TRUE(rig.ask(request::StartSwing{.rate = 3_deg_s, .headings = 0}));
    rig.run(Seconds(80.0));
    ASSERT_EQ(CalibrationRun::Swing, rig.status().progress.run);
    profile::Profile typed = rig.profile;
    typed.pointing.azimuthOffset = 50_deg;
    rig.setProfile(typed);
    rig.run(Seconds(3.0));
    EXPECT_EQ(CalibrationRun::None, rig.status().progress.run);
    EXPECT_TRUE(rig.status().progress.failed);
    EXPECT_EQ(StationState::Hold, rig.state());
}

// After control was handed to the clients, no request of the operator's side takes it back a second later.
// REQ-NORTH-35a: Giving control to the clients, or to one of them, ends the motion of a calibration. No request of the
// operator takes control back.
TEST(CalibrationFollow, EndsWhenTheClientsAreGivenControl)
{
    SwungRig rig;
    setHour(rig, 8.0);
    follow(rig);
    ASSERT_TRUE(rig.ask(request::GiveAuthority{}));
    rig.run(Seconds(5.0));
    EXPECT_FALSE(rig.status().following);
    EXPECT_EQ(Authority::Clients, rig.control.authority());
    EXPECT_EQ(StationState::Hold, rig.state());
    EXPECT_TRUE(rig.point(120.0, 30.0, kClient));
}

// REQ-NORTH-35a
TEST(CalibrationFollow, ASwingEndsWhenAClientIsGivenTheLead)
{
    for (const int headings : {0, 16}) {
        CalibrationRig rig;
        rig.control.clientCame(kClient, "127.0.0.1");
        rig.goTo(200.0, 30.0);
        ASSERT_TRUE(rig.ask(request::StartSwing{.rate = 3_deg_s, .headings = headings}));
        rig.run(Seconds(40.0));
        ASSERT_EQ(CalibrationRun::Swing, rig.status().progress.run);
        ASSERT_TRUE(rig.ask(request::GiveControl{kClient.clientId}));
        rig.run(Seconds(20.0));
        EXPECT_EQ(CalibrationRun::None, rig.status().progress.run);
        EXPECT_EQ(Authority::Clients, rig.control.authority());
        EXPECT_EQ(StationState::Hold, rig.state());
    }
}

// A single motion of the operator does not repeat its request. It may finish, and a client takes over with its next
// request.
// REQ-NORTH-35a
TEST(CalibrationFollow, ASlewMayEndAfterTheClientsWereGivenControl)
{
    CalibrationRig rig;
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 100_deg, .elevation = 30_deg}}));
    rig.run(Seconds(1.0));
    ASSERT_TRUE(rig.ask(request::GiveAuthority{}));
    rig.run(Seconds(40.0));
    EXPECT_NEAR(100.0, rig.axes().azimuth.degrees(), 0.01);
    EXPECT_EQ(Authority::Clients, rig.control.authority());
}

// The slew would end at a direction that nobody asked for.
// REQ-NORTH-38
TEST(CalibrationFollow, ApplyWaitsUntilASlewHasArrived)
{
    CalibrationRig rig;
    ASSERT_TRUE(rig.ask(request::TakeKnownPoint{.truth = {.azimuth = 10_deg, .elevation = 30_deg}, .label = {}}));
    ASSERT_TRUE(rig.ask(request::PointSky{{.azimuth = 200_deg, .elevation = 30_deg}}));
    const auto atOnce = rig.apply();
    ASSERT_FALSE(atOnce);
    rig.run(Seconds(2.0));
    EXPECT_FALSE(rig.apply());
    EXPECT_FALSE(rig.status().proposal->obstacle.isEmpty());
    rig.run(Seconds(60.0));
    const AxisPosition arrived = rig.axes();
    EXPECT_TRUE(rig.apply());
    rig.run(Seconds(3.0));
    EXPECT_EQ(arrived, rig.axes());
}

// When the targets of a stream stop, the mount follows their path a little longer. Position readings of a client do not
// change how long.
TEST(CalibrationFollow, AClientThatReadsSaysNothingAboutIt)
{
    const auto restsAt = [](bool reads) {
        CalibrationRig rig;
        rig.goTo(100.0, 30.0);
        for (int second = 0; second < 20; ++second) {
            const SkyPointing direction{.azimuth = 100_deg + 0.5_deg * second, .elevation = 30_deg};
            EXPECT_TRUE(rig.control.request(request::Follow{.direction = direction, .what = QStringLiteral("Moon")},
                                            calibrationSource()));
            rig.run(Seconds(1.0));
        }
        for (int i = 0; i < 500; ++i) {
            if (reads) {
                rig.control.positionRead(kClient.clientId);
            }
            rig.tick();
        }
        return rig.axes().azimuth;
    };
    EXPECT_EQ(restsAt(false), restsAt(true));
}

TEST(CalibrationFollow, WhatIsRefusedChangesNothing)
{
    SwungRig rig;
    setHour(rig, 8.0);
    follow(rig);
    rig.tick();
    ASSERT_FALSE(rig.status().bodies.at(1).isUp);
    ASSERT_FALSE(rig.ask(request::FollowBody{.body = Body::Moon, .refraction = ephemeris::Refraction::Radio}));
    EXPECT_EQ(ephemeris::Refraction::Light, rig.status().refraction);
    EXPECT_EQ(Body::Sun, rig.status().body);
    EXPECT_TRUE(rig.status().following);
}

// Story: the Sun was tracked, then the mount was sent to 300° 40°. One click took a point of the "Sun" with the beam
// 66° away from it.
// REQ-NORTH-37c: After a body was tracked, a point of it may be taken as long as the mount was only held, stopped,
// jogged and stepped, however far that is by the model. A point far from a north that was already found is reported in
// the log. Whatever sends the mount elsewhere or hands over control ends this.
TEST(CalibrationFollow, NoPointIsTakenOnceTheMountWasSentElsewhere)
{
    const AxisPosition elsewhere{.azimuth = 300_deg, .elevation = 40_deg};
    const std::vector<Request> requests{request::PointSky{{elsewhere.azimuth, elsewhere.elevation}},
                                        request::PointAxes{elsewhere},
                                        request::Move{{.azimuth = 1_deg_s}},
                                        request::Park{},
                                        request::Home{},
                                        request::Horizon{},
                                        request::GiveAuthority{},
                                        CalibrationRequest(request::StartSwing{.rate = 3_deg_s, .headings = 0})};
    for (const Request& sent : requests) {
        SwungRig rig;
        setHour(rig, 8.0);
        follow(rig);
        ASSERT_EQ(Body::Sun, rig.status().body);
        const auto answer = rig.ask(sent);
        ASSERT_TRUE(answer) << textOf(answer.error());
        rig.run(Seconds(1.0));
        ASSERT_TRUE(rig.ask(request::EndCalibration{}));
        ASSERT_TRUE(rig.ask(request::Hold{}));
        rig.run(Seconds(5.0));
        const auto taken = rig.ask(request::TakePoint{});
        ASSERT_FALSE(taken) << sent.index();
        EXPECT_NE(std::string::npos, textOf(taken.error()).find("Track the Sun or the Moon first"));
        EXPECT_FALSE(rig.status().body) << sent.index();
        EXPECT_FALSE(rig.status().pointObstacle.isEmpty());
        follow(rig);
        EXPECT_TRUE(rig.ask(request::TakePoint{}));
    }
}

// REQ-NORTH-37c
TEST(CalibrationFollow, NoPointIsTakenAfterAClientLedTheMount)
{
    SwungRig rig;
    setHour(rig, 8.0);
    follow(rig);
    ASSERT_TRUE(rig.ask(request::Hold{}));
    ASSERT_TRUE(rig.ask(request::GiveAuthority{}));
    ASSERT_TRUE(rig.point(120.0, 30.0, kClient));
    rig.run(Seconds(1.0));
    ASSERT_TRUE(rig.ask(request::TakeAuthority{}));
    rig.run(Seconds(5.0));
    EXPECT_FALSE(rig.ask(request::TakePoint{}));
}

// If north is wrong by 37°, the operator centres the body by hand, however far that is.
// REQ-NORTH-37c
TEST(CalibrationFollow, APointIsTakenWhatWasCentredByHand)
{
    CalibrationRig rig;
    setHour(rig, 8.0);
    follow(rig);
    ASSERT_TRUE(rig.ask(request::Stop{}));
    rig.run(Seconds(1.0));
    ASSERT_TRUE(rig.ask(request::ResetStop{}));
    ASSERT_TRUE(rig.ask(request::Jog{{.azimuth = -3_deg_s}}));
    rig.run(Seconds(0.5));
    ASSERT_TRUE(rig.ask(request::Hold{}));
    ASSERT_TRUE(rig.ask(request::Nudge{.azimuth = -1_deg, .elevation = {}}));
    rig.run(Seconds(5.0));
    const AxisPosition wanted = rig.model.toAxes(rig.status().bodies.at(0).direction).axes;
    ASSERT_TRUE(rig.ask(request::Step{.azimuth = (wanted.azimuth - rig.axes().azimuth).wrapped180(),
                                      .elevation = wanted.elevation - rig.axes().elevation}));
    rig.run(Seconds(20.0));
    const auto taken = rig.ask(request::TakePoint{});
    ASSERT_TRUE(taken) << textOf(taken.error());
    EXPECT_EQ(std::string::npos, rig.lastLog().find("By the model in force")) << "no north has been found yet";
    EXPECT_EQ(Body::Sun, rig.status().body);
    ASSERT_TRUE(rig.apply());
    EXPECT_NEAR(37.4, rig.terms().azimuthOffset.degrees(), 1.0);
}

// After north was found, a point far from it is still taken, because the operator sees the body. The log reports it.
// REQ-NORTH-37c
TEST(CalibrationFollow, APointFarFromTheNorthThatWasFoundIsToldOf)
{
    SwungRig rig;
    takeSun(rig, 8.0);
    ASSERT_TRUE(rig.apply());
    follow(rig);
    ASSERT_TRUE(rig.ask(request::TakePoint{}));
    EXPECT_EQ(std::string::npos, rig.lastLog().find("By the model in force"));
    ASSERT_TRUE(rig.ask(request::Hold{}));
    ASSERT_TRUE(rig.ask(request::Step{.azimuth = 20_deg, .elevation = {}}));
    rig.run(Seconds(20.0));
    ASSERT_TRUE(rig.ask(request::TakePoint{}));
    EXPECT_NE(std::string::npos, rig.lastLog().find("By the model in force")) << rig.lastLog();
}

bool warnsOfTheSun(CalibrationRig& rig)
{
    return rig.control.alarms().active(alarmEntry("sun.followed"));
}

TEST(CalibrationFollow, TheMoonBearsNoAlarmOfTheSun)
{
    SwungRig rig;
    setHour(rig, 15.0);
    follow(rig);
    EXPECT_TRUE(warnsOfTheSun(rig));
    ASSERT_TRUE(rig.status().bodies.at(1).isUp);
    follow(rig, Body::Moon);
    EXPECT_FALSE(warnsOfTheSun(rig));
    follow(rig);
    EXPECT_TRUE(warnsOfTheSun(rig));
}

// Story: sun.keep_away was switched on, and the mount moved by 5° in the next second.
// REQ-CONTROL-39
TEST(CalibrationFollow, KeepingAwayFromTheSunMovesNothing)
{
    SwungRig rig;
    setHour(rig, 8.0);
    follow(rig);
    const AxisPosition before = rig.axes();
    profile::Profile careful = rig.profile;
    careful.sun.keepAway = profile::KeepAway::On;
    rig.setProfile(careful);
    EXPECT_NE(std::string::npos, rig.lastLog().find("keeps the beam away")) << rig.lastLog();
    rig.run(Seconds(10.0));
    EXPECT_FALSE(rig.status().following);
    EXPECT_EQ(StationState::Hold, rig.state());
    EXPECT_LT(abs(rig.axes().azimuth - before.azimuth), 0.02_deg);
    EXPECT_LT(abs(rig.axes().elevation - before.elevation), 0.02_deg);
    EXPECT_TRUE(rig.control.alarms().active(alarmEntry("sun.near")));
    EXPECT_FALSE(warnsOfTheSun(rig)) << "one alarm says it";
    EXPECT_TRUE(rig.status().warning.isEmpty());
}

// Story: Hold and Apply ended the tracking, and the alarm ended with the beam only 0.01° beside the Sun.
// REQ-NORTH-37d: The warning about eyes and feed lasts from the request to go to the Sun until the beam has left the
// Sun. It also appears when any other request points the beam at the Sun: within half the beam width, or 1°.
TEST(CalibrationFollow, TheWarningStaysWhileTheBeamLooksIntoTheSun)
{
    SwungRig rig;
    setHour(rig, 8.0);
    follow(rig);
    EXPECT_TRUE(warnsOfTheSun(rig));
    ASSERT_TRUE(rig.ask(request::Hold{}));
    rig.run(Seconds(5.0));
    EXPECT_TRUE(warnsOfTheSun(rig));
    EXPECT_FALSE(rig.status().warning.isEmpty());
    rig.clock.stepUtc(std::chrono::hours(1));
    rig.run(Seconds(1.0));
    EXPECT_FALSE(warnsOfTheSun(rig)) << "the Sun went on";
    EXPECT_TRUE(rig.status().warning.isEmpty());
    follow(rig);
    rig.goTo(300.0, 30.0);
    EXPECT_FALSE(warnsOfTheSun(rig)) << "the beam went away";
}

// REQ-NORTH-37d
TEST(CalibrationFollow, WhoeverLedTheBeamToTheSunIsWarned)
{
    SwungRig rig;
    setHour(rig, 8.0);
    rig.run(Seconds(1.0));
    const SkyPointing sun = rig.status().bodies.at(0).direction;
    ASSERT_TRUE(rig.ask(request::PointSky{sun}));
    rig.run(Seconds(60.0));
    EXPECT_TRUE(warnsOfTheSun(rig));
    EXPECT_FALSE(rig.status().warning.isEmpty());
    setHour(rig, 23.0);
    rig.run(Seconds(1.0));
    EXPECT_FALSE(warnsOfTheSun(rig));

    // A beam that only passes through the Sun raises no warning.
    setHour(rig, 8.0);
    ASSERT_TRUE(rig.ask(request::PointSky{{sun.azimuth - 30_deg, sun.elevation}}));
    rig.run(Seconds(60.0));
    ASSERT_TRUE(rig.ask(request::PointSky{{sun.azimuth + 30_deg, sun.elevation}}));
    Angle nearest = 180_deg;
    for (int i = 0; i < 600; ++i) {
        rig.run(Seconds(0.1));
        nearest = std::min(nearest, angleBetween(*rig.control.direction(), sun));
        EXPECT_FALSE(warnsOfTheSun(rig));
    }
    EXPECT_LT(nearest, 1_deg);
}

// The position that a client reads is the direction of the beam, as on the screen and in MQTT.
TEST(CalibrationFollow, TheTrimIsPartOfWhatClientsAreTold)
{
    SwungRig rig;
    setHour(rig, 8.0);
    follow(rig);
    ASSERT_TRUE(rig.ask(request::Nudge{.azimuth = 5_deg, .elevation = {}}));
    rig.run(Seconds(5.0));
    StationRotator rotator(rig.control, rig.inForce, rig.log, rig.clock);
    const auto told = rotator.position({.id = 1, .address = "127.0.0.1:50000"});
    ASSERT_TRUE(told);
    EXPECT_LT(apart({told->azimuth, told->elevation}, *rig.control.status().actual), 0.01);
}

TEST(CalibrationFollow, ATrimThatIsNoNumberIsRefused)
{
    SwungRig rig;
    setHour(rig, 8.0);
    follow(rig);
    const Angle none = Angle::fromDegrees(std::numeric_limits<double>::quiet_NaN());
    EXPECT_FALSE(rig.ask(request::Nudge{.azimuth = none, .elevation = {}}));
    EXPECT_FALSE(rig.ask(request::Nudge{.azimuth = {}, .elevation = none}));
    EXPECT_FALSE(rig.control.status().trim);
}

}  // namespace
}  // namespace boresight
