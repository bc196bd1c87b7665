// SPDX-License-Identifier: GPL-3.0-or-later
// Boresight recognises the target that a client tracks, and tracks it from its own orbit.
#include "tests/core/control/lock/lock_rig.h"

namespace boresight {
namespace {

using testing::HasSubstr;
using testing::Not;

// REQ-TRACK-1810: With clients.lock = "always" Boresight tracks the target of a client from its own orbit as soon as
// the points of the client move along the target. The client keeps control. Its points are accepted and do not move the
// mount, so the error is that of a target that Boresight tracks. The status names the target.
TEST_F(StationLock, TracksTheSatelliteOfTheClient)
{
    beginInThePass();
    ASSERT_TRUE(isLocked());
    StationStatus status = rig.control.status();
    EXPECT_EQ(shown()->name.toStdString(), "TEST ONE");
    EXPECT_EQ(shown()->clientId, kClient.clientId);
    ASSERT_TRUE(status.tracked);
    EXPECT_EQ(status.tracked->number, found.elements.number);
    EXPECT_GT(status.tracked->way->size(), 10U);
    EXPECT_EQ(status.targetText.toStdString(), "track TEST ONE");
    EXPECT_EQ(status.commander, kClient);
    EXPECT_EQ(status.state, StationState::Track);
    EXPECT_EQ(status.authority, Authority::Clients);
    EXPECT_EQ(lines("tracks TEST ONE. Boresight tracks it from its own orbit from now on"), 1);
    track(Seconds(10.0), 1_deg);
    EXPECT_LT(off(), 0.03_deg) << "the points of the client do not move the mount";
    read(Seconds(30.0));
    EXPECT_TRUE(isLocked()) << "a client that is on target only reads";
    EXPECT_LT(off(), 0.03_deg);
}

// REQ-TRACK-1811: A client that waits for the rise sends one point at the horizon and reads the position. That is too
// little for a lock by itself, because the point may be a place on the Earth. So with "always", too, the satellite that
// rises there is only offered. Without an answer the mount stays at the horizon after the rise, until the points of the
// client move along the satellite.
TEST_F(StationLock, APointAtTheHorizonIsOnlyOffered)
{
    ASSERT_TRUE(rig.ask(request::PointSky{rise()}, kClient));
    rig.run(Seconds(6.0));
    EXPECT_FALSE(shown()) << "nobody reads";
    read(Seconds(30.0));
    ASSERT_TRUE(shown());
    EXPECT_FALSE(isLocked());
    EXPECT_EQ(lines("waits for the rise of TEST ONE"), 1);
    while (now() < found.pass.aos.utc + std::chrono::seconds(60)) {
        read(Seconds(1.0));
    }
    EXPECT_FALSE(isLocked());
    EXPECT_FALSE(rig.control.status().tracked);
    EXPECT_LT(angleBetween(*rig.control.status().actual, rise()), 0.1_deg);
    track(Seconds(20.0));
    EXPECT_TRUE(isLocked()) << "the points move along the satellite";
}

// REQ-TRACK-1829: If the operator accepts the target before its rise, the mount waits at the horizon, and follows the
// satellite from its rise.
TEST_F(StationLockAsk, ALockMayBeginBeforeTheRise)
{
    ASSERT_TRUE(rig.ask(request::PointSky{rise()}, kClient));
    read(Seconds(30.0));
    ASSERT_TRUE(accept());
    ASSERT_TRUE(isLocked());
    EXPECT_FALSE(rig.control.status().tracked->isUp);
    EXPECT_LT(angleBetween(*rig.control.status().actual, rise()), 0.1_deg);
    ASSERT_TRUE(rig.ask(request::PointSky{rise()}, kClient));
    while (now() < found.pass.aos.utc + std::chrono::seconds(30)) {
        read(Seconds(1.0));
    }
    EXPECT_TRUE(isLocked());
    EXPECT_LT(off(), 0.03_deg);
}

// The points of the pass before do not count while the client waits for the next rise.
TEST_F(StationLockAsk, TheNextRiseIsRecognisedAfterAPass)
{
    know({});
    for (int i = 0; i < 8; ++i) {
        ASSERT_TRUE(rig.point(100.0 + 0.5 * i, 20.0));
        read(Seconds(1.0));
    }
    know({found.elements});
    ASSERT_TRUE(rig.ask(request::PointSky{rise()}, kClient));
    read(Seconds(20.0));
    ASSERT_TRUE(shown());
    EXPECT_EQ(shown()->name.toStdString(), "TEST ONE");
}

// REQ-TRACK-1830: A lock begins only for a client that has read the position in the last 3 s.
TEST_F(StationLock, AClientThatNeverReadsGetsNoLock)
{
    runUntil(found.pass.aos.utc + std::chrono::seconds(60));
    for (int i = 0; i < 30; ++i) {
        ASSERT_TRUE(send());
        rig.run(Seconds(1.0));
    }
    EXPECT_FALSE(shown());
    track(Seconds(10.0));
    EXPECT_TRUE(isLocked());
}

TEST_F(StationLockAsk, AClientThatReadsNoMoreGetsNoLock)
{
    beginInThePass();
    ASSERT_TRUE(shown());
    rig.run(Seconds(4.0));
    const Result<> refused = accept();
    ASSERT_FALSE(refused);
    EXPECT_THAT(textOf(refused.error()), HasSubstr("The client has not read the position in the last 3 s."));
    read(Seconds(1.0));
    EXPECT_TRUE(accept());
}

// REQ-TRACK-1812: With "ask" the target is offered, and the log has one line. Nothing changes until the operator
// accepts it. The operator does not take control by that. A target that was refused is not offered to this client
// again.
TEST_F(StationLockAsk, OffersTheTargetOnce)
{
    beginInThePass();
    ASSERT_TRUE(shown());
    EXPECT_FALSE(isLocked());
    EXPECT_FALSE(rig.control.status().tracked);
    EXPECT_EQ(lines("tracks TEST ONE. Boresight can track it from its own orbit"), 1);
    EXPECT_FALSE(accept(QStringLiteral("TEST ONE"), kOtherClient.clientId));
    const request::TrackForClient yes{.clientId = kClient.clientId, .target = QStringLiteral("TEST ONE")};
    EXPECT_FALSE(rig.ask(yes, kClient)) << "a client cannot accept";
    ASSERT_TRUE(rig.ask(request::TrackForClient{
        .clientId = kClient.clientId, .target = QStringLiteral("TEST ONE"), .isWanted = false}));
    EXPECT_FALSE(shown());
    track(Seconds(10.0));
    EXPECT_FALSE(shown());
    EXPECT_EQ(lines("Boresight can track it from its own orbit"), 1);
}

TEST_F(StationLockAsk, TheOperatorAccepts)
{
    beginInThePass();
    const Result<> before = accept(QStringLiteral("TEST TWO"));
    ASSERT_FALSE(before) << "the prompt named another target";
    EXPECT_EQ(textOf(before.error()), "The client tracks another target now: TEST ONE.");
    ASSERT_TRUE(accept());
    EXPECT_TRUE(isLocked());
    EXPECT_EQ(rig.control.status().authority, Authority::Clients);
    track(Seconds(5.0), 1_deg);
    EXPECT_LT(off(), 0.03_deg);
    const Result<> again = accept();
    ASSERT_FALSE(again);
    EXPECT_EQ(textOf(again.error()), "Boresight offers no target of this client any more.");
}

// A target that was accepted is offered again in its next pass.
TEST_F(StationLockAsk, TheNextPassIsOfferedAgain)
{
    beginInThePass();
    ASSERT_TRUE(accept());
    rig.clock.setUtc(found.pass.los.utc - std::chrono::seconds(10));
    read(Seconds(15.0));
    EXPECT_FALSE(shown());
    EXPECT_EQ(lines("TEST ONE has set, and the mount holds"), 1);
    EXPECT_FALSE(hasNotice());
    EXPECT_TRUE(stands());
    rig.clock.setUtc(found.pass.aos.utc + std::chrono::seconds(60));
    track(Seconds(20.0));
    ASSERT_TRUE(shown());
    EXPECT_FALSE(isLocked());
    EXPECT_EQ(lines("tracks TEST ONE. Boresight can track it from its own orbit"), 2);
    EXPECT_TRUE(accept());
}

// REQ-TRACK-1813: With "never", without a site and without elements nothing is recognised. The points of the client
// move the mount.
TEST_F(StationLockNever, NothingIsRecognised)
{
    beginInThePass();
    EXPECT_FALSE(shown());
    EXPECT_FALSE(rig.control.status().tracked);
    EXPECT_EQ(rig.state(), StationState::Track);
}

TEST_F(StationLock, NothingIsRecognisedWithoutASite)
{
    apply([](profile::Profile& profile) { profile.site.known = false; });
    beginInThePass();
    EXPECT_FALSE(shown());
    EXPECT_EQ(rig.state(), StationState::Track);
}

// With rotctld.outside_limits = "refuse", too: a lock would follow the target along the limits, and refuse nothing.
TEST_F(StationLock, NothingIsRecognisedWhereLimitsRefuse)
{
    apply([](profile::Profile& profile) { profile.rotctld.outsideLimits = profile::OutsideLimits::Refuse; });
    beginInThePass();
    EXPECT_FALSE(shown());
    EXPECT_FALSE(rig.control.status().tracked);
    EXPECT_EQ(rig.state(), StationState::Track);
}

// REQ-TRACK-1814: If several satellites fit alike, the points of the client move the mount. One line of the log
// names them.
TEST_F(StationLock, AmbiguityIsReportedOnce)
{
    know({found.elements, behind(90'001, "TEST TWO", 0.13_deg)});
    beginInThePass();
    track(Seconds(10.0));
    EXPECT_FALSE(shown());
    EXPECT_EQ(lines("The points fit several targets alike: TEST ONE, TEST TWO"), 1);
    EXPECT_EQ(rig.state(), StationState::Track);
}

TEST_F(StationLock, ATrainIsReportedOnce)
{
    know(train());
    ASSERT_TRUE(rig.ask(request::PointSky{rise()}, kClient));
    read(Seconds(10.0));
    EXPECT_FALSE(shown()) << "before the rise";
    EXPECT_EQ(lines("The points fit several targets alike: TEST ONE, TRAIN 101, TRAIN 102 and 17 more."), 1);
    while (now() < found.pass.aos.utc + std::chrono::seconds(60)) {
        read(Seconds(1.0));
    }
    track(Seconds(50.0));
    EXPECT_FALSE(shown());
    EXPECT_EQ(lines("The points fit several targets alike"), 1);
}

// REQ-TRACK-1819: Another client does not get control by the lock, and its points are refused as before.
TEST_F(StationLock, OtherClientsWait)
{
    rig.control.clientCame(kOtherClient, "10.0.0.9");
    beginInThePass();
    ASSERT_TRUE(isLocked());
    const Result<> refused = send({}, kOtherClient);
    ASSERT_FALSE(refused);
    EXPECT_THAT(textOf(refused.error()), HasSubstr("rotctld 1 has control"));
    read(Seconds(5.0));
    const Result<> later = send({}, kOtherClient);
    ASSERT_FALSE(later);
    EXPECT_THAT(textOf(later.error()), HasSubstr("It sent its last command"));
    EXPECT_THAT(textOf(later.error()), Not(HasSubstr("a moment ago"))) << "the lock is no command of the client";
    EXPECT_TRUE(isLocked());
}

}  // namespace
}  // namespace boresight
