// SPDX-License-Identifier: GPL-3.0-or-later
// A jog of a GS-232 rotator whose motors are only switched on and off: out of each other motion, and before the
// directions of the axes are confirmed.
#include "tests/core/gs232_mount/gs232_bench.h"

#include <gtest/gtest.h>

namespace boresight::gs232 {
namespace {

void jog(Gs232Bench& bench, const AxisRates& rates, Seconds time)
{
    constexpr Seconds kEach{0.1};
    for (Seconds left = time; left > Seconds(0.0); left -= kEach) {
        (void)bench.ask(request::Jog{.rates = rates});
        bench.run(kEach);
    }
}

// REQ-GS232-39: Who releases a jog key or holds sends a stop at once. Nothing that waits is sent behind it.
TEST(SwitchedMotorEnd, AReleasedKeyStopsTheMotorAtOnce)
{
    Gs232Bench bench(switchedProfile());
    bench.run(Seconds(2.0));
    for (int i = 0; i < 40; ++i) {
        ASSERT_TRUE(bench.ask(request::Jog{.rates = {.azimuth = 6_deg_s}}));
        bench.run(Seconds(0.1));
    }
    ASSERT_GT(bench.truth().azimuth, 20_deg) << "it starts within a second";
    EXPECT_EQ(bench.box().starts(), 1);
    const Angle released = bench.truth().azimuth;
    ASSERT_TRUE(bench.ask(request::Hold{}));
    bench.run(Seconds(0.1));
    EXPECT_EQ(bench.heardOf("S"), 1);
    bench.run(Seconds(10.0));
    EXPECT_LT(bench.truth().azimuth, released + 1.5_deg);
    EXPECT_EQ(bench.box().starts(), 1);
    for (int i = 0; i < 40; ++i) {
        ASSERT_TRUE(bench.ask(request::Jog{.rates = {.azimuth = -6_deg_s}}));
        bench.run(Seconds(0.1));
    }
    EXPECT_LT(bench.truth().azimuth, released - 5_deg);
}

// REQ-GS232-63: A short tap of a jog key moves the axis while the key is down, and not after that.
TEST(SwitchedMotorJog, ATapMovesItWhileTheKeyIsDown)
{
    for (const AngularRate rate : {6_deg_s, -6_deg_s, 1_deg_s, -1_deg_s}) {
        for (const int ticks : {2, 5, 8, 12}) {
            Gs232Bench bench(switchedProfile());
            bench.run(Seconds(2.0));
            ASSERT_TRUE(bench.goTo(100.0, 40.0));
            bench.run(Seconds(40.0));
            const Angle before = bench.truth().azimuth;
            for (int i = 0; i < ticks; ++i) {
                ASSERT_TRUE(bench.ask(request::Jog{.rates = {.azimuth = rate}}));
                bench.run(Seconds(0.1));
            }
            const Angle released = bench.truth().azimuth;
            const double way = rate < AngularRate{} ? -1.0 : 1.0;
            EXPECT_GT(way * (released - before), Angle::fromDegrees(0.1)) << rate.degrees() << " " << ticks;
            ASSERT_TRUE(bench.ask(request::Hold{}));
            bench.run(Seconds(0.1));
            const int starts = bench.box().starts();
            bench.run(Seconds(10.0));
            EXPECT_LT(abs(bench.truth().azimuth - released), 1.3_deg) << rate.degrees() << " " << ticks;
            EXPECT_EQ(bench.box().starts(), starts) << rate.degrees() << " " << ticks;
            EXPECT_EQ(bench.box().starts(Axis::Elevation), 1);
            EXPECT_EQ(bench.heardOf("S"), 2) << "one before the jog";
        }
    }
}

TEST(SwitchedMotorJog, AHeldKeyStartsTheMotorOnce)
{
    Gs232Bench bench(switchedProfile());
    bench.run(Seconds(2.0));
    for (int i = 0; i < 150; ++i) {
        ASSERT_TRUE(bench.ask(request::Jog{.rates = {.azimuth = 6_deg_s}}));
        bench.run(Seconds(0.1));
    }
    EXPECT_EQ(bench.box().starts(), 1);
    EXPECT_GT(bench.truth().azimuth, 80_deg);
}

profile::Profile wideBeam()
{
    profile::Profile profile = switchedProfile();
    profile.mount.beamWidth = 40_deg;
    return profile;
}

// A moving target, at an elevation that is not in the middle of its dead-band.
void track(Gs232Bench& bench, double seconds)
{
    for (double time = 0.0; time < seconds; time += 0.2) {
        ASSERT_TRUE(bench.control().request(request::PointAxes{{.azimuth = Angle::fromDegrees(60.0 + 0.5 * time),
                                                                .elevation = Angle::fromDegrees(30.0 + 0.3 * time)}},
                                            kClient));
        bench.run(Seconds(0.2));
    }
}

// REQ-GS232-66: A jog out of tracking starts the motor of its own axis alone. The other axis stops where it is: it does
// not go on to its target, and not back to its set-point.
TEST(SwitchedMotorJog, OutOfTrackingMovesItsOwnAxisAlone)
{
    for (int when = 0; when < 20; ++when) {
        Gs232Bench bench(wideBeam());
        bench.run(Seconds(2.0));
        track(bench, 30.0 + 0.9 * when);
        const AxisPosition before = bench.truth();
        const int starts = bench.box().starts(Axis::Elevation);
        jog(bench, {.azimuth = -6_deg_s}, Seconds(8.0));
        EXPECT_LT(bench.truth().azimuth, before.azimuth - 5_deg) << when;
        EXPECT_NEAR(bench.truth().elevation.degrees(), before.elevation.degrees(), 1.7) << when;
        EXPECT_EQ(bench.box().starts(Axis::Elevation), starts) << when;
        EXPECT_FALSE(bench.control().faultLatched());
    }
}

// REQ-GS232-66
TEST(SwitchedMotorJog, OutOfASlewStopsBothAxesFirst)
{
    Gs232Bench bench(switchedProfile());
    bench.run(Seconds(2.0));
    ASSERT_TRUE(bench.goTo(200.0, 80.0));
    bench.run(Seconds(4.0));
    const AxisPosition before = bench.truth();
    jog(bench, {.azimuth = -2_deg_s}, Seconds(0.5));
    EXPECT_EQ(bench.heardOf("S"), 1);
    jog(bench, {.azimuth = -2_deg_s}, Seconds(5.0));
    EXPECT_LT(bench.truth().azimuth, before.azimuth - 1_deg);
    EXPECT_NEAR(bench.truth().elevation.degrees(), before.elevation.degrees(), 2.0);
}

// Story: after a slew that had ended beyond its set-point, a slow tap moved nothing.
TEST(SwitchedMotorJog, ATapAfterASlewThatEndedBesideItsTargetMovesTheAxis)
{
    for (const Angle coast : {1_deg, 2_deg}) {
        for (const AngularRate rate : {1_deg_s, -1_deg_s}) {
            Gs232Bench bench(switchedProfile());
            bench.box().faults().coast = coast;
            bench.run(Seconds(2.0));
            ASSERT_TRUE(bench.goTo(60.0, 40.0));
            bench.run(Seconds(30.0));
            const Angle before = bench.truth().azimuth;
            jog(bench, {.azimuth = rate}, Seconds(0.5));
            const double way = rate < AngularRate{} ? -1.0 : 1.0;
            EXPECT_GT(way * (bench.truth().azimuth - before), Angle::fromDegrees(0.1)) << coast.degrees();
        }
    }
}

// REQ-GS232-65: Before the directions of the axes are confirmed, an axis is sent no farther than 2°: a jog has no lead.
TEST(SwitchedMotorJog, HasNoLeadBeforeTheDirectionsAreConfirmed)
{
    for (const AngularRate rate : {1_deg_s, -1_deg_s}) {
        profile::Profile profile = switchedProfile();
        profile.mount.directions = profile::Directions::Unconfirmed;
        profile.mount.beamWidth = 40_deg;
        Gs232Bench bench(profile);
        bench.run(Seconds(2.0));
        jog(bench, {.elevation = rate}, Seconds(15.0));
        const Angle away = abs(bench.truth().elevation - kBetweenDegrees.elevation);
        EXPECT_GT(away, 0.5_deg) << rate.degrees();
        EXPECT_LE(away, 3_deg) << rate.degrees();
        for (const std::string& one : bench.box().heard()) {
            EXPECT_FALSE(one.starts_with("W") && (one > "W010 023" || one < "W010 019")) << one;
        }
    }
}

// A slew is no place beside a target: a wide way before its end does not count as tracking.
TEST(SwitchedMotorState, ASlewIsNotOnTarget)
{
    profile::Profile profile = switchedProfile();
    profile.mount.beamWidth = 2_deg;
    Gs232Bench bench(profile);
    bench.run(Seconds(2.0));
    bool tracks = false;
    for (double time = 0.0; time < 40.0; time += 0.1) {
        const Angle azimuth = Angle::fromDegrees(100.0 + 0.5 * time);
        ASSERT_TRUE(bench.control().request(request::PointAxes{{.azimuth = azimuth, .elevation = 21_deg}}, kClient));
        bench.run(Seconds(0.1));
        const bool isOnTarget = bench.control().state() == StationState::Track;
        EXPECT_FALSE(isOnTarget && abs(bench.truth().azimuth - azimuth) > 5_deg) << time;
        tracks = tracks || isOnTarget;
    }
    EXPECT_TRUE(tracks);
}

}  // namespace
}  // namespace boresight::gs232
