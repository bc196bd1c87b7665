// SPDX-License-Identifier: GPL-3.0-or-later
// The status of a slew: the remaining time and the path of the beam. Also the setting that both axes arrive together.
#include "tests/core/control/station_rig.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace boresight {
namespace {

class StationSlew : public ::testing::Test
{
protected:
    static profile::Profile settings(const pointing::Region& limits = {})
    {
        profile::Profile profile;
        profile.limits = limits;
        profile.park = {.azimuth = 200_deg, .elevation = 80_deg};
        return profile;
    }

    static void standAt(StationRig& rig, Angle azimuth, Angle elevation)
    {
        rig.run(Seconds(0.2));
        ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = azimuth, .elevation = elevation}}));
        rig.settle(Seconds(200.0));
        ASSERT_FALSE(rig.control.status().slew);
    }

    // Runs to the end of the slew. The remaining time shown at each moment must prove right within 10 % or 0.5 s.
    static void expectTrueToTheEnd(StationRig& rig)
    {
        struct Shown
        {
            SteadyTime when;
            SlewProgress slew;
        };
        std::vector<Shown> shown;
        for (int i = 0; i < 20'000 && (i < 25 || rig.state() == StationState::Slew); ++i) {
            rig.tick();
            const StationStatus status = rig.control.status();
            if (status.slew) {
                EXPECT_EQ(status.state, StationState::Slew);
                EXPECT_FALSE(status.route.empty() && status.slew->remaining > Seconds(0.3));
                shown.push_back({rig.clock.now(), *status.slew});
            }
        }
        ASSERT_GT(shown.size(), 20U);
        EXPECT_NE(rig.state(), StationState::Slew);
        EXPECT_TRUE(rig.control.status().route.empty());
        const SteadyTime end = rig.clock.now();
        double done = 0.0;
        for (const Shown& one : shown) {
            const double left = Seconds(end - one.when).count();
            EXPECT_NEAR(one.slew.remaining.count(), left, std::max(0.5, 0.1 * left));
            EXPECT_GE(one.slew.done, done - 0.02);
            EXPECT_LE(one.slew.done, 1.0);
            done = one.slew.done;
        }
        EXPECT_LT(shown.front().slew.done, 0.1);
        EXPECT_GT(done, 0.9);
    }

    // The angle that the beam turns along the whole route.
    static double turning(const std::vector<SkyPointing>& route)
    {
        double sum = 0.0;
        for (std::size_t i = 1; i < route.size(); ++i) {
            sum += (route[i].azimuth - route[i - 1].azimuth).wrapped180().degrees();
        }
        return sum;
    }
};

// REQ-CONTROL-400 (StationSlew.*): While the mount slews, the status shows the remaining time, right within 10 % or 0.5
// s, and the part that is done. It also shows the coming path of the beam, with enough points to draw it.
TEST_F(StationSlew, AGoTo)
{
    StationRig rig(settings());
    rig.run(Seconds(0.2));
    EXPECT_FALSE(rig.control.status().slew);
    ASSERT_TRUE(rig.point(113, 10, kOperator));
    expectTrueToTheEnd(rig);
}

TEST_F(StationSlew, AroundAKeepOut)
{
    StationRig rig(settings({.keepOuts = {{.name = "mast",
                                           .azimuthFrom = 300_deg,
                                           .azimuthTo = 330_deg,
                                           .elevationMin = 0_deg,
                                           .elevationMax = 40_deg}}}));
    standAt(rig, 290_deg, 5_deg);
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 340_deg, .elevation = 5_deg}}));
    expectTrueToTheEnd(rig);
}

TEST_F(StationSlew, ParkHomeAndAStep)
{
    StationRig rig(settings());
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.ask(request::Park{}));
    expectTrueToTheEnd(rig);
    ASSERT_TRUE(rig.ask(request::Home{}));
    expectTrueToTheEnd(rig);
    ASSERT_TRUE(rig.ask(request::Step{.azimuth = 5_deg, .elevation = 5_deg}));
    expectTrueToTheEnd(rig);
}

TEST_F(StationSlew, AClientsTarget)
{
    StationRig rig(settings());
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.point(200, 70));
    expectTrueToTheEnd(rig);
}

TEST_F(StationSlew, BothAxesTogether)
{
    profile::Profile profile = settings();
    profile.control.arrival = profile::Arrival::Together;
    StationRig rig(profile);
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.point(150, 20, kOperator));
    rig.run(Seconds(8.0));
    const StationStatus half = rig.control.status();
    EXPECT_NEAR(half.elevation.actual->degrees() / 20.0, half.azimuth.actual->degrees() / 150.0, 0.1);
    const SteadyTime then = rig.clock.now();
    rig.settle();
    EXPECT_NEAR(Seconds(rig.clock.now() - then).count(), half.slew->remaining.count(), 0.8);
}

// The setting applies at once, during a slew.
TEST_F(StationSlew, TogetherIsChosenOnTheWay)
{
    StationRig rig(settings());
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.point(150, 40, kOperator));
    rig.run(Seconds(1.0));
    profile::Profile changed = rig.profile;
    changed.control.arrival = profile::Arrival::Together;
    rig.setProfile(changed);
    rig.run(Seconds(9.0));
    EXPECT_LT(rig.elevationDegrees(), 39.0);
    EXPECT_GT(rig.elevationDegrees(), 10.0);
}

// The limits become faster or slower during the slew. The remaining time is right again.
TEST_F(StationSlew, OtherLimitsOnTheWay)
{
    StationRig rig(settings());
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.point(170, 10, kOperator));
    rig.run(Seconds(5.0));
    profile::Profile changed = rig.profile;
    changed.azimuth.limits.speed = 4_deg_s;
    rig.setProfile(changed);
    rig.run(Seconds(0.5));
    const Seconds remaining = rig.control.status().slew->remaining;
    const SteadyTime then = rig.clock.now();
    rig.settle();
    EXPECT_NEAR(Seconds(rig.clock.now() - then).count(), remaining.count(), 0.1 * remaining.count());
}

TEST_F(StationSlew, WhatEndsItEndsWhatIsShown)
{
    StationRig rig(settings());
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.point(170, 10, kOperator));
    rig.run(Seconds(2.0));
    ASSERT_TRUE(rig.control.status().slew);
    ASSERT_FALSE(rig.control.status().route.empty());
    ASSERT_TRUE(rig.ask(request::Stop{}));
    rig.tick();
    EXPECT_FALSE(rig.control.status().slew);
    EXPECT_TRUE(rig.control.status().route.empty());
}

// Story: during a slew from 0° to 170°, a go-to to 300° went on to 300°, and not back to -60°, which is nearer.
// REQ-CONTROL-1741 (StationSlew.ANewTarget*, StationSlew.AStream*): A new target in a slew is approached on the wrap
// nearest to where the axes can stop. The target before does not count. The points of one stream stay on one wrap, also
// while the axes lag behind.
TEST_F(StationSlew, ANewTargetOfTheOperatorIsNearestToTheMount)
{
    StationRig rig(settings());
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.point(170, 10, kOperator));
    rig.run(Seconds(4.0));
    ASSERT_LT(rig.azimuthDegrees(), 60.0);
    ASSERT_TRUE(rig.point(300, 10, kOperator));
    EXPECT_NEAR(rig.control.status().azimuth.target->degrees(), -60.0, 0.01);
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), -60.0, 0.1);
    // An azimuth alone.
    ASSERT_TRUE(rig.point(100, 10, kOperator));
    rig.run(Seconds(3.0));
    ASSERT_TRUE(rig.ask(request::PointAxis{.axis = Axis::Azimuth, .angle = 290_deg}));
    EXPECT_NEAR(rig.control.status().azimuth.target->degrees(), -70.0, 0.01);
}

TEST_F(StationSlew, ANewTargetOfAClientIsNearestToTheMount)
{
    StationRig rig(settings());
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.point(170, 10));
    rig.run(Seconds(4.0));
    ASSERT_TRUE(rig.point(300, 10));
    EXPECT_NEAR(rig.control.status().azimuth.target->degrees(), -60.0, 0.01);
}

TEST_F(StationSlew, AStreamStaysOnItsWrapWhileTheAxesLag)
{
    StationRig rig(settings());
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.point(170, 10));
    double azimuth = 170.0;
    // The target is faster than the mount. In the end it is 200° ahead.
    for (int second = 0; second < 10; ++second) {
        rig.run(Seconds(1.0));
        azimuth += 20.0;
        ASSERT_TRUE(rig.point(std::fmod(azimuth, 360.0), 10));
    }
    EXPECT_GT(rig.control.status().azimuth.target->degrees(), 300.0);
}

// A step is counted from where the axes are going, so it stays on that wrap.
TEST_F(StationSlew, AStepStaysOnTheWrapOfTheSlew)
{
    StationRig rig(settings());
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 270_deg, .elevation = 10_deg}}));
    rig.run(Seconds(1.0));
    ASSERT_TRUE(rig.ask(request::Step{.azimuth = 5_deg, .elevation = 0_deg}));
    EXPECT_NEAR(rig.control.status().azimuth.target->degrees(), 275.0, 0.01);
}

// REQ-CONTROL-401: If the cable ends on the short path, the long path is shown. When the cable is unwrapped, a full
// turn is shown.
TEST_F(StationSlew, TheLongWayIsShownAsItWillBeGone)
{
    StationRig rig(settings());  // -90…450°
    standAt(rig, 440_deg, 30_deg);
    ASSERT_TRUE(rig.point(100, 30, kOperator));
    rig.run(Seconds(0.2));
    const StationStatus status = rig.control.status();
    EXPECT_NEAR(turning(status.route), -340.0, 2.0) << "not the 20° that end beyond the cable";
    EXPECT_GT(status.route.size(), 150U);
    for (std::size_t i = 1; i < status.route.size(); ++i) {
        EXPECT_LE(abs((status.route[i].azimuth - status.route[i - 1].azimuth).wrapped180()), 2.01_deg);
    }
    EXPECT_EQ(status.route.front(), *status.commanded);
    EXPECT_NEAR(status.route.back().azimuth.degrees(), 100.0, 1e-6);
    expectTrueToTheEnd(rig);
}

// REQ-CONTROL-401
TEST_F(StationSlew, UnwrappingIsAWholeTurn)
{
    StationRig rig(settings());
    standAt(rig, 425_deg, 30_deg);
    ASSERT_TRUE(rig.ask(request::Unwind{}));
    rig.run(Seconds(0.2));
    EXPECT_NEAR(turning(rig.control.status().route), -360.0, 2.0);
    expectTrueToTheEnd(rig);
}

// REQ-CONTROL-407: A stream that unwraps the cable during tracking shows its path and its remaining time, too.
TEST_F(StationSlew, AStreamThatTurnsBackShowsItsWayAndItsTime)
{
    StationRig rig(settings());
    standAt(rig, 440_deg, 30_deg);
    ASSERT_TRUE(rig.ask(request::GiveAuthority{}));
    double azimuth = 440.0;
    const auto point = [&] {
        EXPECT_TRUE(rig.point(std::fmod(azimuth += 0.5, 360.0), 30.0));
        rig.run(Seconds(1.0));
    };
    while (azimuth < 451.0) {
        point();
    }
    ASSERT_EQ(rig.state(), StationState::Slew);
    const StationStatus status = rig.control.status();
    ASSERT_TRUE(status.slew);
    EXPECT_LT(turning(status.route), -300.0);
    const SteadyTime then = rig.clock.now();
    while (rig.state() == StationState::Slew && azimuth < 520.0) {
        point();
    }
    EXPECT_NEAR(Seconds(rig.clock.now() - then).count(), status.slew->remaining.count(), 2.0) << "a point a second";
    EXPECT_EQ(rig.state(), StationState::Track);
    EXPECT_FALSE(rig.control.status().slew);
    EXPECT_TRUE(rig.control.status().route.empty());
}

// REQ-CONTROL-402: The log line at the start of a motion to a place says how long the motion takes.
TEST_F(StationSlew, TheLogNamesItsTime)
{
    StationRig rig(settings());
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.point(113, 10, kOperator));
    EXPECT_EQ(rig.lastLog(), "moves the mount from 0.00° 0.00°: go to 113.00° 10.00°, there in 13 s");
    const SteadyTime then = rig.clock.now();
    rig.settle();
    EXPECT_NEAR(Seconds(rig.clock.now() - then).count(), 13.0, 1.3);
    profile::Profile slow = rig.profile;
    slow.azimuth.limits.speed = 0.5_deg_s;
    rig.setProfile(slow);
    ASSERT_TRUE(rig.ask(request::Home{}));
    EXPECT_EQ(rig.lastLog(), "moves the mount from 113.00° 10.00°: home to 0.00° 0.00°, there in 3 min 47 s");
}

// Story: at 35° on the way to 210° another go-to came, and the log said that the mount moves from 210°.
// REQ-CONTROL-1740: The log line at the start of a motion names the direction where the mount is, also when the motion
// ends a slew.
TEST_F(StationSlew, TheLogNamesWhereTheMountIs)
{
    StationRig rig(settings());
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.point(210, 10, kOperator));
    rig.run(Seconds(4.0));
    ASSERT_EQ(rig.state(), StationState::Slew);
    const double azimuth = rig.azimuthDegrees();
    ASSERT_TRUE(rig.point(40, 10, kOperator));
    const QString line = QString::fromStdString(rig.lastLog());
    const QString before = QStringLiteral("moves the mount from ");
    ASSERT_TRUE(line.startsWith(before)) << rig.lastLog();
    EXPECT_NEAR(line.mid(before.size()).section(u'°', 0, 0).toDouble(), azimuth, 1.0) << rig.lastLog();
}

// REQ-CONTROL-932: The status reports the electrical power of each axis and the sum. The energy of a motion is summed
// from its first tick until the mount stands. Power that is fed back counts negative. The highest power is kept with
// the energy until the next motion ends. The power of standing still is not included.
TEST(StationEnergy, AMotionIsSummedUpFromItsBeginToItsEnd)
{
    StationRig rig;
    rig.run(Seconds(0.5));
    rig.azimuth.power = 30.0;
    rig.elevation.power = -10.0;
    ASSERT_TRUE(rig.point(20.0, 10.0));
    rig.run(Seconds(1.0));
    StationStatus status = rig.control.status();
    EXPECT_EQ(status.azimuth.power, 30.0);
    EXPECT_EQ(status.elevation.power, -10.0);
    EXPECT_EQ(status.power.total, 20.0);
    ASSERT_TRUE(status.power.running);
    EXPECT_NEAR(status.power.running->joules, 20.0, 1.5);
    EXPECT_EQ(status.power.running->peak, 20.0);
    EXPECT_FALSE(status.power.last);
    rig.settle();
    rig.azimuth.power = 1000.0;
    rig.run(Seconds(10.0));
    status = rig.control.status();
    EXPECT_FALSE(status.power.running);
    ASSERT_TRUE(status.power.last);
    EXPECT_EQ(status.power.last->unknown, Seconds{});
    EXPECT_NEAR(status.power.last->joules, 20.0 * status.power.last->time.count(), 1.0);
    EXPECT_EQ(status.power.last->peak, 20.0) << "what came behind it is no part of it";
}

// REQ-CONTROL-933: Power that is not reported for more than 0.1 s is not guessed. The gap adds nothing to the energy,
// and its length is reported.
TEST(StationEnergy, AGapIsToldAndNotGuessed)
{
    StationRig rig;
    rig.run(Seconds(0.5));
    rig.azimuth.power = 100.0;
    ASSERT_TRUE(rig.point(40.0, 0.0));
    rig.run(Seconds(2.0));
    const double before = rig.control.status().power.running.value().joules;
    rig.azimuth.mute = true;
    rig.run(Seconds(0.14));
    rig.azimuth.mute = false;
    rig.run(Seconds(0.02));
    const MotionEnergy after = rig.control.status().power.running.value();
    EXPECT_LE(after.joules - before, 4.1) << "a tick on each side, and nothing of the gap";
    EXPECT_NEAR(after.unknown.count(), 0.14, 0.05);
}

}  // namespace
}  // namespace boresight
