// SPDX-License-Identifier: GPL-3.0-or-later
// What ends the lock to the target of a client, and what does not.
#include "tests/core/control/lock/lock_rig.h"
#include "tests/core/recognise/client_points.h"

namespace boresight {
namespace {

using testing::HasSubstr;

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
    EXPECT_THAT(notice(), HasSubstr("The points of the client move the mount."));
    EXPECT_EQ(rig.control.status().commander, kClient);
    rig.run(Seconds(6.0));
    EXPECT_LT(angleBetween(*rig.control.status().actual, last), 0.1_deg) << "the mount goes to the last point";
    rig.run(Seconds(60.0));
    EXPECT_FALSE(hasNotice()) << "a notice ends by itself";
}

// REQ-TRACK-1831: The client may be ahead of its target by the lead that its points showed before the lock, and by 3°
// more. So a client with a threshold of 5° keeps the lock, and a client whose points were exact does not.
TEST_F(StationLock, AnExactClientThatGoesAheadDeparts)
{
    beginInThePass();
    ASSERT_TRUE(isLocked());
    for (int i = 0; i < 7; ++i) {
        ASSERT_TRUE(rig.ask(request::PointSky{ahead(5_deg)}, kClient));
        read(Seconds(1.0));
    }
    EXPECT_FALSE(isLocked());
    EXPECT_TRUE(hasNotice());
}

TEST_F(StationLock, AClientWithAThresholdMayBeAhead)
{
    runUntil(found.pass.aos.utc + std::chrono::seconds(60));
    const auto points = fakes::pointsOf(targets::satelliteTarget(found.elements), kLockSite,
                                        now() + std::chrono::seconds(1), 2, {.ahead = 5_deg});
    for (const recognise::SentPoint& point : points) {
        while (now() < point.utc) {
            read(Seconds(1.0));
        }
        ASSERT_TRUE(rig.ask(request::PointSky{point.direction}, kClient));
    }
    read(Seconds(5.0));
    ASSERT_TRUE(isLocked());
    for (int i = 0; i < 10; ++i) {
        ASSERT_TRUE(rig.ask(request::PointSky{ahead(5_deg)}, kClient));
        read(Seconds(1.0));
    }
    EXPECT_TRUE(isLocked());
    EXPECT_LT(off(), 0.03_deg);
}

// REQ-TRACK-1816: S, M and Park of the client, another client that moves the mount, and a client that leaves or is
// silent for 10 s end the lock with a notice, which says what moves the mount now. The mount holds within 0.3 s after
// S, and does not go on to a point after the client has left.
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
        EXPECT_THAT(notice(), HasSubstr("The mount holds."));
        EXPECT_EQ(rig.state(), StationState::Hold);
        EXPECT_TRUE(stands());
    }
    rig.control.clientCame(kClient, "127.0.0.1");
    track(Seconds(20.0));
    ASSERT_TRUE(isLocked());
    ASSERT_TRUE(rig.ask(request::Park{}, kClient));
    rig.run(Seconds(0.2));
    EXPECT_FALSE(isLocked());
    EXPECT_THAT(notice(), HasSubstr("the client parked the mount. The mount moves to its park position."));
}

TEST_F(StationLock, AMoveCommandOfTheClientEndsIt)
{
    beginInThePass();
    ASSERT_TRUE(isLocked());
    ASSERT_TRUE(rig.ask(request::Move{{.azimuth = 1_deg_s}}, kClient));
    rig.run(Seconds(0.2));
    EXPECT_FALSE(isLocked());
    EXPECT_THAT(notice(), HasSubstr("the client sent a move command. The move command of the client moves the mount."));
}

TEST_F(StationLock, AnotherClientEndsIt)
{
    apply([](profile::Profile& profile) { profile.rotctld.control = profile::ControlRule::Last; });
    rig.control.clientCame(kOtherClient, "10.0.0.9");
    beginInThePass();
    ASSERT_TRUE(isLocked());
    ASSERT_TRUE(rig.point(20.0, 30.0, kOtherClient));
    rig.run(Seconds(0.2));
    EXPECT_FALSE(isLocked());
    EXPECT_THAT(notice(), HasSubstr("another client moves the mount."));
    EXPECT_EQ(rig.control.status().commander, kOtherClient);
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

// A lock that the settings permit no more ends with a notice, and the mount holds.
TEST_F(StationLock, SettingsEndIt)
{
    const std::vector<std::pair<std::function<void(profile::Profile&)>, const char*>> changes{
        {[](profile::Profile& profile) { profile.clientLock = profile::ClientLock::Never; },
         "the setting clients.lock is \"never\". The mount holds."},
        {[](profile::Profile& profile) { profile.rotctld.outsideLimits = profile::OutsideLimits::Refuse; },
         "the setting rotctld.outside_limits is \"refuse\". The mount holds."},
    };
    for (const auto& [change, words] : changes) {
        runUntil(std::max(now(), found.pass.aos.utc + std::chrono::seconds(60)));
        track(Seconds(20.0));
        ASSERT_TRUE(isLocked());
        const profile::Profile before = rig.profile;
        apply(change);
        EXPECT_FALSE(isLocked());
        EXPECT_THAT(notice(), HasSubstr(words));
        EXPECT_TRUE(stands());
        track(Seconds(10.0));
        EXPECT_FALSE(shown());
        rig.setProfile(before);
    }
}

// REQ-TRACK-1818: New elements of the locked satellite change nothing in the pass. They count at the next lock.
TEST_F(StationLock, NewElementsWaitForTheNextLock)
{
    beginInThePass();
    ASSERT_TRUE(isLocked());
    know({behind(found.elements.number, found.elements.name, 0.2_deg)});
    track(Seconds(10.0));
    EXPECT_TRUE(isLocked());
    EXPECT_FALSE(hasNotice());
    EXPECT_LT(off(), 0.03_deg);
    ASSERT_TRUE(rig.ask(request::Hold{}, kClient));
    rig.run(Seconds(1.0));
    track(Seconds(20.0));
    EXPECT_TRUE(isLocked());
    EXPECT_GT(off(), 0.1_deg) << "the new elements are 3 s behind";
}

// REQ-TRACK-1832: A clock that is set leaves the lock if the target is up then, or rises soon. Otherwise the lock ends,
// and the mount holds.
TEST_F(StationLock, AClockThatIsSet)
{
    beginInThePass();
    ASSERT_TRUE(isLocked());
    rig.clock.stepUtc(Seconds(30.0));
    track(Seconds(20.0));
    EXPECT_TRUE(isLocked());
    EXPECT_LT(off(), 0.03_deg);
    rig.clock.stepUtc(Seconds(-3600.0));
    rig.run(Seconds(1.0));
    EXPECT_FALSE(isLocked());
    EXPECT_EQ(lines("ends the tracking, because the clock was set"), 1);
    EXPECT_TRUE(stands());
}

// REQ-TRACK-1833: While a lock lasts, the antenna in use stays in use.
TEST_F(StationLock, TheAntennaStaysInUse)
{
    apply([](profile::Profile& profile) {
        profile.antennas = {{.name = "13 cm", .beamWidth = 1_deg, .across = -8_deg}};
    });
    beginInThePass();
    ASSERT_TRUE(isLocked());
    const std::string before = rig.control.status().antenna;
    const Result<> other = rig.ask(request::UseAntenna{"13 cm"});
    ASSERT_FALSE(other);
    EXPECT_THAT(textOf(other.error()), HasSubstr("Press Hold first."));
    track(Seconds(5.0));
    EXPECT_TRUE(isLocked());
    EXPECT_EQ(rig.control.status().antenna, before);
    EXPECT_LT(off(), 0.03_deg);
}

}  // namespace
}  // namespace boresight
