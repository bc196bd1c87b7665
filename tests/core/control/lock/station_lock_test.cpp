// SPDX-License-Identifier: GPL-3.0-or-later
// Boresight recognises the target that a client tracks, and tracks it from its own orbit.
#include "core/alarms/catalogue.h"
#include "core/units/angle_between.h"
#include "tests/core/control/station_rig.h"
#include "tests/fakes/found_orbit.h"
#include "tests/fakes/text_of.h"

#include <QThreadPool>

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>

namespace boresight {
namespace {

using testing::HasSubstr;

const Site kLockSite{.latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};

profile::Profile lockProfile(profile::ClientLock lock)
{
    profile::Profile profile;
    profile.site = {.known = true,
                    .latitude = kLockSite.latitude,
                    .longitude = kLockSite.longitude,
                    .heightMetres = kLockSite.heightMetres};
    profile.control.tickHz = 20;  // the lowest
    profile.control.watchdog = Seconds(0.2);
    profile.clientLock = lock;
    return profile;
}

// A client that sends the direction of a satellite each second, and reads the position.
class StationLock : public ::testing::Test
{
protected:
    explicit StationLock(profile::ClientLock lock = profile::ClientLock::Always) : rig(lockProfile(lock))
    {
        rig.onTick = [] { QThreadPool::globalInstance()->waitForDone(); };  // a recognition arrives in the next tick
        rig.control.clientCame(kClient, "127.0.0.1");
        rig.run(Seconds(0.5));
        found = fakes::orbitWith(kLockSite, now(), [&](const passes::Pass& pass) {
            const Seconds wait = pass.aos.utc - now();
            const Angle highest = pass.tca.direction.elevation;
            return Seconds(60.0) < wait && wait < Seconds(200.0) && 40_deg < highest && highest < 60_deg &&
                   !pass.isUpAtEnd;
        });
        know({found.elements});
    }

    void know(const std::vector<orbit::ElementSet>& sets)
    {
        EXPECT_TRUE(rig.control.receive(std::make_shared<const std::vector<orbit::ElementSet>>(sets)));
    }
    [[nodiscard]] UtcTime now() const { return rig.clock.utc(); }
    [[nodiscard]] SkyPointing direction() const
    {
        SkyPointing there = fakes::directionOf(found, kLockSite, now());
        there.elevation = std::max(there.elevation, 0_deg);
        return there;
    }
    // The point of the client, away from the satellite by this angle in azimuth.
    Result<> send(Angle away = {}, const Source& client = kClient)
    {
        SkyPointing there = direction();
        there.azimuth = there.azimuth + away;
        return rig.ask(request::PointSky{there}, client);
    }
    // The client sends its point each second.
    void track(Seconds time, Angle away = {})
    {
        for (Seconds left = time; left > Seconds(0.0); left -= Seconds(1.0)) {
            EXPECT_TRUE(send(away));
            rig.control.positionRead(kClient.clientId);
            rig.run(Seconds(1.0));
        }
    }
    // The client only reads.
    void read(Seconds time)
    {
        for (Seconds left = time; left > Seconds(0.0); left -= Seconds(1.0)) {
            rig.control.positionRead(kClient.clientId);
            rig.run(Seconds(1.0));
        }
    }
    void runUntil(UtcTime utc)
    {
        while (now() < utc) {
            rig.tick();
        }
    }
    // The way to the satellite takes 30 s.
    void beginInThePass()
    {
        runUntil(found.pass.aos.utc + std::chrono::seconds(60));
        track(Seconds(40.0));
    }
    [[nodiscard]] std::optional<RecognisedTarget> shown() const { return rig.control.status().clientTarget; }
    [[nodiscard]] bool isLocked() const { return shown() && shown()->isLocked; }
    [[nodiscard]] bool hasNotice() const { return rig.alarms.active(alarmEntry("client.lock-ended")); }
    [[nodiscard]] Angle off() const { return angleBetween(*rig.control.status().commanded, direction()); }
    [[nodiscard]] bool stands()
    {
        rig.run(Seconds(3.0));
        const SkyPointing before = *rig.control.status().actual;
        rig.run(Seconds(5.0));
        return angleBetween(before, *rig.control.status().actual) < 0.02_deg;
    }
    [[nodiscard]] int lines(const char* words) const
    {
        const auto all = rig.log.since(0, EventLog::kCapacity);
        return static_cast<int>(
            std::ranges::count_if(all, [&](const LogEntry& line) { return line.text.contains(QLatin1String(words)); }));
    }

    StationRig rig;
    fakes::FoundOrbit found;
};

class StationLockAsk : public StationLock
{
protected:
    StationLockAsk() : StationLock(profile::ClientLock::Ask) {}
};

class StationLockNever : public StationLock
{
protected:
    StationLockNever() : StationLock(profile::ClientLock::Never) {}
};

// REQ-TRACK-1810: With clients.lock = "always" Boresight tracks the target of a client from its own orbit as soon as it
// recognises the target. The client keeps control. Its points are accepted and do not move the mount, so the error is
// that of a target that Boresight tracks. The status names the target.
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

// REQ-TRACK-1811: A client that waits for the rise sends one point at the horizon and reads the position. The mount
// waits there, and follows the satellite from its rise. A client that does not read is not locked to.
TEST_F(StationLock, ALockMayBeginBeforeTheRise)
{
    const SkyPointing rise{.azimuth = found.pass.aos.direction.azimuth, .elevation = {}};
    ASSERT_TRUE(rig.ask(request::PointSky{rise}, kClient));
    rig.run(Seconds(6.0));
    EXPECT_FALSE(shown()) << "nobody reads";
    read(Seconds(30.0));
    ASSERT_TRUE(isLocked());
    EXPECT_FALSE(rig.control.status().tracked->isUp);
    EXPECT_LT(angleBetween(*rig.control.status().actual, rise), 0.1_deg);
    ASSERT_TRUE(rig.ask(request::PointSky{rise}, kClient));
    while (now() < found.pass.aos.utc + std::chrono::seconds(30)) {
        read(Seconds(1.0));
    }
    EXPECT_TRUE(isLocked());
    EXPECT_LT(off(), 0.03_deg);
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
    const Result<> other = rig.ask(request::TrackForClient{.clientId = kOtherClient.clientId});
    EXPECT_FALSE(other);
    EXPECT_FALSE(rig.ask(request::TrackForClient{.clientId = kClient.clientId}, kClient)) << "a client cannot accept";
    ASSERT_TRUE(rig.ask(request::TrackForClient{.clientId = kClient.clientId, .isWanted = false}));
    EXPECT_FALSE(shown());
    track(Seconds(10.0));
    EXPECT_FALSE(shown());
    EXPECT_EQ(lines("Boresight can track it from its own orbit"), 1);
}

TEST_F(StationLockAsk, TheOperatorAccepts)
{
    beginInThePass();
    ASSERT_TRUE(rig.ask(request::TrackForClient{.clientId = kClient.clientId}));
    EXPECT_TRUE(isLocked());
    EXPECT_EQ(rig.control.status().authority, Authority::Clients);
    track(Seconds(5.0), 1_deg);
    EXPECT_LT(off(), 0.03_deg);
    const Result<> again = rig.ask(request::TrackForClient{.clientId = kClient.clientId});
    ASSERT_FALSE(again);
    EXPECT_EQ(textOf(again.error()), "Boresight offers no target of this client any more.");
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
    profile::Profile nowhere = rig.profile;
    nowhere.site.known = false;
    rig.setProfile(nowhere);
    beginInThePass();
    EXPECT_FALSE(shown());
    EXPECT_EQ(rig.state(), StationState::Track);
}

// REQ-TRACK-1814: If several satellites fit alike, the points of the client move the mount. One line of the log
// names them.
TEST_F(StationLock, AmbiguityIsReportedOnce)
{
    orbit::ElementSet behind = found.elements;
    behind.number = 90'001;
    behind.name = "TEST TWO";
    behind.meanAnomaly = behind.meanAnomaly - 0.13_deg;
    know({found.elements, behind});
    beginInThePass();
    track(Seconds(10.0));
    EXPECT_FALSE(shown());
    EXPECT_EQ(lines("The points fit several targets alike: TEST ONE, TEST TWO"), 1);
    EXPECT_EQ(rig.state(), StationState::Track);
}

// REQ-TRACK-1815: The lock ends with a notice when the points of the client are more than 3° from the target for 5 s.
// Then the points of the client move the mount again, first the last one.
TEST_F(StationLock, EndsWhenTheClientDeparts)
{
    beginInThePass();
    ASSERT_TRUE(isLocked());
    track(Seconds(4.0), 15_deg);
    EXPECT_TRUE(isLocked()) << "less than 5 s";
    track(Seconds(2.0));
    track(Seconds(4.0), 15_deg);
    EXPECT_TRUE(isLocked()) << "it was back meanwhile";
    ASSERT_TRUE(send(15_deg));
    const SkyPointing last{.azimuth = direction().azimuth + 15_deg, .elevation = direction().elevation};
    rig.run(Seconds(3.0));
    EXPECT_FALSE(isLocked());
    EXPECT_TRUE(hasNotice());
    EXPECT_EQ(rig.control.status().commander, kClient);
    rig.run(Seconds(6.0));
    EXPECT_LT(angleBetween(*rig.control.status().actual, last), 0.1_deg) << "the mount goes to the last point";
    rig.run(Seconds(60.0));
    EXPECT_FALSE(hasNotice()) << "a notice ends by itself";
}

// REQ-TRACK-1816: S and Park of the client, and a client that leaves or is silent for 10 s, end the lock with a notice.
// The mount holds within 0.3 s after S, and does not go on to a point after the client has left.
TEST_F(StationLock, EndsWhenTheClientStopsParksOrLeaves)
{
    const std::vector<std::function<void()>> enders{
        [&] { ASSERT_TRUE(rig.ask(request::Hold{}, kClient)); },
        [&] { rig.control.sourceGone(kClient); },
        [&] {
            ASSERT_TRUE(rig.ask(request::Hold{}, kClient));
            rig.control.sourceGone(kClient);  // before the next tick, as when Gpredict disengages
        },
        [&] { rig.run(Seconds(11.0)); },
    };
    for (const auto& end : enders) {
        rig.control.clientCame(kClient, "127.0.0.1");
        runUntil(std::max(now(), found.pass.aos.utc + std::chrono::seconds(60)));
        track(Seconds(20.0));
        ASSERT_TRUE(isLocked());
        end();
        rig.run(Seconds(0.3));
        EXPECT_FALSE(isLocked());
        EXPECT_TRUE(hasNotice());
        EXPECT_EQ(rig.state(), StationState::Hold);
        EXPECT_TRUE(stands());
    }
    rig.control.clientCame(kClient, "127.0.0.1");
    track(Seconds(20.0));
    ASSERT_TRUE(isLocked());
    ASSERT_TRUE(rig.ask(request::Park{}, kClient));
    rig.run(Seconds(0.2));
    EXPECT_FALSE(isLocked());
    EXPECT_TRUE(hasNotice());
}

// REQ-TRACK-1817: STOP, Hold and Take control by the operator, a fault, a strong wind and a changed site end the lock.
// It does not begin again by itself: first the client must move the mount again.
TEST_F(StationLock, EverythingThatEndsAMotionEndsIt)
{
    const std::vector<std::function<void()>> enders{
        [&] { ASSERT_TRUE(rig.ask(request::Stop{})); },
        [&] { ASSERT_TRUE(rig.ask(request::Hold{})); },
        [&] { ASSERT_TRUE(rig.ask(request::TakeAuthority{})); },
        [&] { ASSERT_TRUE(rig.ask(request::SetReadOnly{.clientId = kClient.clientId})); },
        [&] {
            profile::Profile elsewhere = rig.profile;
            elsewhere.site.latitude = elsewhere.site.latitude + 0.001_deg;
            rig.setProfile(elsewhere);
        },
    };
    for (const auto& end : enders) {
        runUntil(std::max(now(), found.pass.aos.utc + std::chrono::seconds(60)));
        track(Seconds(8.0));
        ASSERT_TRUE(isLocked());
        end();
        rig.run(Seconds(0.3));
        EXPECT_FALSE(isLocked());
        EXPECT_TRUE(stands());
        EXPECT_FALSE(isLocked());
        (void)rig.ask(request::ResetStop{});
        (void)rig.ask(request::SetReadOnly{.clientId = kClient.clientId, .readOnly = false});
        (void)rig.ask(request::GiveAuthority{});
        EXPECT_TRUE(stands());
        EXPECT_FALSE(isLocked());
    }
}

TEST_F(StationLock, AFaultEndsIt)
{
    beginInThePass();
    ASSERT_TRUE(isLocked());
    rig.azimuth.fault = 38;
    rig.azimuth.mode = moteus::Mode::Fault;
    rig.run(Seconds(0.5));
    EXPECT_EQ(rig.state(), StationState::Fault);
    EXPECT_FALSE(isLocked());
    EXPECT_FALSE(send());
}

TEST_F(StationLock, AStrongWindEndsIt)
{
    profile::Profile windy = rig.profile;
    windy.wind.source = "udp:4541";
    rig.setProfile(windy);
    beginInThePass();
    ASSERT_TRUE(isLocked());
    rig.control.takeWind(30.0);
    rig.run(Seconds(1.0));
    EXPECT_FALSE(isLocked());
    EXPECT_NE(rig.control.status().commander, kClient);
}

// REQ-TRACK-1818: New elements of the locked satellite end the lock with a notice, and the mount holds until the next
// point of the client. Elements that did not change end nothing.
TEST_F(StationLock, NewElementsEndIt)
{
    beginInThePass();
    ASSERT_TRUE(isLocked());
    know({found.elements});
    EXPECT_TRUE(isLocked());
    orbit::ElementSet newer = found.elements;
    newer.bstar = 2e-5;
    know({newer});
    EXPECT_FALSE(isLocked());
    EXPECT_TRUE(hasNotice());
    EXPECT_TRUE(stands());
    track(Seconds(8.0));
    EXPECT_TRUE(isLocked()) << "recognised again";
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
    track(Seconds(3.0));
    EXPECT_TRUE(isLocked());
}

}  // namespace
}  // namespace boresight
