// SPDX-License-Identifier: GPL-3.0-or-later
// Motors that are only switched on and off: what starts them, what does not, and where they stand meanwhile.
#include "tests/core/gs232_mount/gs232_bench.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace boresight::gs232 {
namespace {

// Of a satellite that culminates at 57° in the south, eight minutes long.
AxisPosition passAt(double seconds)
{
    const double half = std::numbers::pi * seconds / 480.0;
    return {.azimuth = Angle::fromDegrees(180.0 - 80.0 * std::cos(half)),
            .elevation = Angle::fromDegrees(2.0 + 55.0 * std::sin(half))};
}

std::vector<pointing::KeepOut> mast(double from, double to, double top)
{
    return {{.name = "mast",
             .azimuthFrom = Angle::fromDegrees(from),
             .azimuthTo = Angle::fromDegrees(to),
             .elevationMin = 0_deg,
             .elevationMax = Angle::fromDegrees(top)}};
}

// Not farther inside than the rotator may miss its place.
bool isInside(const AxisPosition& place, double from, double to, double top)
{
    constexpr double kMiss = 1.5;
    return place.azimuth.degrees() > from + kMiss && place.azimuth.degrees() < to - kMiss &&
           place.elevation.degrees() < top - kMiss;
}

profile::Profile withStarts(int most)
{
    profile::Profile profile = gs232Profile();
    profile.control.startsPerMinute = most;
    return profile;
}

void jogFor(Gs232Bench& bench, double seconds, const AxisRates& rates)
{
    for (double time = 0.0; time < seconds; time += 0.1) {
        ASSERT_TRUE(bench.ask(request::Jog{.rates = rates}));
        bench.run(Seconds(0.1));
    }
}

void followFrom(Gs232Bench& bench, int from, int to)
{
    for (int second = from; second < to; ++second) {
        ASSERT_TRUE(bench.control().request(request::PointAxes{passAt(second)}, kClient));
        bench.run(Seconds(1.0));
    }
}

// REQ-GS232-70 (Gs232KeepOut.*): A rotator that waits in its dead band, that was put off, or whose axes are driven at
// their own pace never stands where the beam is not permitted.
TEST(Gs232KeepOut, TheDeadBandEndsAtAnEdge)
{
    profile::Profile profile = gs232Profile();
    profile.mount.beamWidth = 20_deg;
    profile.limits.keepOuts = mast(172, 186, 56);
    Gs232Bench bench(profile);
    bench.run(Seconds(2.0));
    for (int second = 140; second < 340; ++second) {
        ASSERT_TRUE(bench.control().request(request::PointAxes{passAt(second)}, kClient));
        for (int part = 0; part < 10; ++part) {
            bench.run(Seconds(0.1));
            const AxisPosition at = bench.truth();
            ASSERT_FALSE(isInside(at, 172, 186, 56)) << at.azimuth.degrees() << "° " << at.elevation.degrees() << "°";
        }
    }
    EXPECT_GT(bench.truth().azimuth, 200_deg);
    EXPECT_FALSE(bench.control().faultLatched());
}

TEST(Gs232KeepOut, ASlewLeadsAround)
{
    for (const int most : {2, 10}) {
        profile::Profile profile = withStarts(most);
        profile.limits.keepOuts = mast(80, 100, 50);
        Gs232Bench bench(profile);
        bench.run(Seconds(2.0));
        ASSERT_TRUE(bench.goTo(160.0, 10.0));
        for (int tick = 0; tick < 200 * 50; ++tick) {
            bench.tick();
            const AxisPosition at = bench.truth();
            ASSERT_FALSE(isInside(at, 80, 100, 50)) << at.azimuth.degrees() << "° " << at.elevation.degrees() << "°";
        }
        bench.expectAt({160_deg, 10_deg}, {}, 1_deg);
        EXPECT_LE(bench.box().starts(), 8);
    }
}

// Whatever is asked at whatever moment. The seed is fixed.
TEST(Gs232KeepOut, ARandomWalkNeverStandsInside)
{
    profile::Profile profile = withStarts(60);
    profile.limits.keepOuts = mast(80, 110, 40);
    Gs232Bench bench(profile, Gs232Box::Habits{.coast = 1_deg});
    bench.run(Seconds(2.0));
    std::mt19937 chance(7);
    const auto from = [&chance](int low, int high) {
        return static_cast<double>(low + static_cast<int>(chance() % static_cast<unsigned>(high - low)));
    };
    for (int wish = 0; wish < 60; ++wish) {
        const int kind = static_cast<int>(chance() % 4U);
        if (kind == 0) {
            (void)bench.ask(request::Hold{});
        } else if (kind == 1) {
            (void)bench.ask(request::Move{{.azimuth = AngularRate::fromDegrees(from(-6, 7)),
                                           .elevation = AngularRate::fromDegrees(from(-6, 7))}});
        } else {
            (void)bench.goTo(from(20, 200), from(2, 80));
        }
        const int ticks = static_cast<int>(from(20, 600));
        for (int tick = 0; tick < ticks; ++tick) {
            bench.tick();
            const AxisPosition at = bench.truth();
            ASSERT_FALSE(at.azimuth > 83_deg && at.azimuth < 107_deg && at.elevation < 37_deg)
                << wish << ": " << at.azimuth.degrees() << "° " << at.elevation.degrees() << "°";
        }
    }
    EXPECT_FALSE(bench.control().faultLatched());
}

// REQ-GS232-71 (Gs232Starts.AJog*, Gs232Starts.AStartThatWaits*): A jog waits for no start of the minute, and ends with
// its key. A start that was put off is dropped when nobody wants it any more.
TEST(Gs232Starts, AJogIsNotPutOffAndEndsWithItsKey)
{
    Gs232Bench bench(withStarts(1));
    bench.run(Seconds(2.0));
    ASSERT_TRUE(bench.goTo(30.0, 30.0));
    bench.run(Seconds(15.0));
    const Angle before = bench.truth().azimuth;
    jogFor(bench, 4.0, {.azimuth = 3_deg_s});
    EXPECT_GT(bench.truth().azimuth, before + 3_deg);
    bench.run(Seconds(4.0));
    const int starts = bench.box().starts();
    EXPECT_TRUE(bench.stands(Seconds(130.0)));
    EXPECT_EQ(bench.box().starts(), starts);
    EXPECT_NEAR(bench.truth().elevation.degrees(), 30.0, 0.6) << "nobody asked for it";
}

TEST(Gs232Starts, AStartThatWaitsIsDroppedByHold)
{
    Gs232Bench bench(withStarts(1));
    bench.run(Seconds(2.0));
    ASSERT_TRUE(bench.goTo(30.0, 30.0));
    bench.run(Seconds(15.0));
    ASSERT_TRUE(bench.goTo(60.0, 30.0));
    bench.run(Seconds(5.0));
    EXPECT_TRUE(bench.mount().report(Axis::Azimuth).starts->waits);
    EXPECT_FALSE(bench.mount().report(Axis::Elevation).starts->waits);
    EXPECT_EQ(bench.control().state(), StationState::Slew);
    ASSERT_TRUE(bench.ask(request::Hold{}));
    EXPECT_TRUE(bench.stands(Seconds(130.0)));
    EXPECT_FALSE(bench.mount().report(Axis::Azimuth).starts->waits);
}

TEST(Gs232Starts, AStartThatWaitsComesWhenTheMinuteIsOver)
{
    Gs232Bench bench(withStarts(1));
    bench.run(Seconds(2.0));
    ASSERT_TRUE(bench.goTo(30.0, 30.0));
    bench.run(Seconds(15.0));
    ASSERT_TRUE(bench.goTo(60.0, 30.0));
    bench.run(Seconds(30.0));
    EXPECT_NEAR(bench.truth().azimuth.degrees(), 30.0, 0.6);
    bench.run(Seconds(40.0));
    bench.expectAt({60_deg, 30_deg}, {}, 1_deg);
}

// REQ-GS232-72: Hold starts no motor. One that runs is stopped, and the rotator holds where it stands then.
TEST(Gs232Starts, HoldStartsNothing)
{
    Gs232Bench bench;
    bench.run(Seconds(2.0));
    followFrom(bench, 170, 236);
    for (int second = 236; bench.mount().report(Axis::Azimuth).hand == AxisHand::Follows && second < 250; ++second) {
        followFrom(bench, second, second + 1);
        if (abs(bench.truth().azimuth - passAt(second).azimuth) > 1_deg) {
            break;  // it waits away from its target
        }
    }
    const AxisPosition before = bench.truth();
    const int starts = bench.box().starts();
    ASSERT_TRUE(bench.ask(request::Hold{}));
    bench.run(Seconds(60.0));
    EXPECT_EQ(bench.box().starts(), starts);
    bench.expectAt(before, {}, 3_deg);
    bench.box().faults().offset = 3_deg;  // the wind, or the potentiometer
    bench.run(Seconds(30.0));
    EXPECT_EQ(bench.box().starts(), starts);
    EXPECT_FALSE(bench.control().faultLatched());
}

TEST(Gs232Starts, HoldInMidWayStopsOnce)
{
    Gs232Bench bench;
    bench.run(Seconds(2.0));
    ASSERT_TRUE(bench.goTo(200.0, 20.0));
    bench.run(Seconds(8.0));
    const Angle at = bench.truth().azimuth;
    ASSERT_TRUE(bench.ask(request::Hold{}));
    bench.run(Seconds(10.0));
    EXPECT_EQ(bench.heardOf("S"), 1);
    EXPECT_NEAR(bench.truth().azimuth.degrees(), at.degrees(), 2.0);
    EXPECT_EQ(bench.box().starts(Axis::Azimuth), 1);
    EXPECT_TRUE(bench.stands(Seconds(30.0)));
}

// REQ-GS232-34 (Gs232Starts.AReversal*, SwitchedMotorTest.IsStoppedBeforeItTurnsRound): A motor that is to turn round
// is stopped first, also while its next start has to wait.
TEST(Gs232Starts, AReversalStopsFirstThoughItsStartWaits)
{
    Gs232Bench bench(withStarts(1));
    bench.run(Seconds(2.0));
    ASSERT_TRUE(bench.goTo(200.0, 20.0));
    bench.run(Seconds(8.0));
    const Angle at = bench.truth().azimuth;
    ASSERT_TRUE(bench.goTo(20.0, 20.0));
    bench.run(Seconds(3.0));
    EXPECT_EQ(bench.heardOf("S"), 1);
    EXPECT_LT(bench.truth().azimuth, at + 2_deg);
    EXPECT_TRUE(bench.mount().report(Axis::Azimuth).starts->waits);
    EXPECT_TRUE(bench.stands(Seconds(30.0)));
    bench.run(Seconds(60.0));
    bench.expectAt({20_deg, 20_deg}, {}, 1_deg);
}

// REQ-GS232-73: Silence is a fault also while the rotator was stopped for another target, and while a start waits.
TEST(Gs232Starts, SilenceIsAFaultAtEveryMoment)
{
    for (const double moment : {0.02, 0.5, 1.5, 5.0}) {
        Gs232Bench bench(withStarts(1));
        bench.run(Seconds(2.0));
        ASSERT_TRUE(bench.goTo(200.0, 20.0));
        bench.run(Seconds(8.0));
        ASSERT_TRUE(bench.goTo(20.0, 20.0));
        bench.run(Seconds(moment));
        bench.setLine(false);
        bench.run(bench.silence() + Seconds(0.5));
        EXPECT_TRUE(bench.control().faultLatched()) << moment;
        EXPECT_TRUE(bench.standsOnBoard("rotator.silent")) << moment;
        bench.setLine(true);
        bench.run(Seconds(8.0));
        EXPECT_TRUE(bench.stands(Seconds(90.0))) << moment;
    }
}

// REQ-GS232-35 (Gs232Starts.AreCounted*, SwitchedMotorTest.StartsAreCountedByOrderAndByEye): The starts of each motor
// are counted as they happen: those that are ordered, and those that somebody else makes.
TEST(Gs232Starts, AreCountedAsTheyHappen)
{
    Gs232Bench bench;
    bench.run(Seconds(2.0));
    followFrom(bench, 150, 330);
    ASSERT_TRUE(bench.goTo(100.0, 30.0));
    bench.run(Seconds(4.0));
    ASSERT_TRUE(bench.goTo(250.0, 10.0));
    bench.run(Seconds(40.0));
    for (const Axis axis : kAxes) {
        EXPECT_EQ(bench.mount().report(axis).starts->total, static_cast<std::uint64_t>(bench.box().starts(axis)))
            << index(axis);
    }
    const auto total = [&bench](Axis axis) { return bench.mount().report(axis).starts->total; };
    const auto azimuth = total(Axis::Azimuth);
    const auto elevation = total(Axis::Elevation);
    bench.box().take("M260\r", bench.clock().now());  // somebody at the box
    bench.run(Seconds(10.0));
    EXPECT_EQ(total(Axis::Azimuth), azimuth + 1);
    EXPECT_EQ(total(Axis::Elevation), elevation);
    const int before = bench.box().starts(Axis::Elevation);
    jogFor(bench, 3.0, {.elevation = 3_deg_s});
    bench.run(Seconds(5.0));
    EXPECT_GE(total(Axis::Elevation) - elevation,
              static_cast<std::uint64_t>(bench.box().starts(Axis::Elevation) - before));
    EXPECT_LE(total(Axis::Elevation) - elevation, 7U) << "two orders a second";
}

// REQ-GS232-36 (Gs232Starts.AMotionOfOneAxis*, SwitchedMotorTest.TellsWhenItMustNotBeNamed): A command for one axis
// starts no motor of the other one, wherever that stands.
TEST(Gs232Starts, AMotionOfOneAxisStartsNoOther)
{
    Gs232Bench bench(gs232Profile(), Gs232Box::Habits{.coast = 2_deg});
    bench.run(Seconds(2.0));
    ASSERT_TRUE(bench.goTo(60.0, 40.0));
    bench.run(Seconds(60.0));
    const int azimuth = bench.box().starts(Axis::Azimuth);
    const AxisPosition place = *bench.mount().measured();
    ASSERT_TRUE(bench.ask(request::PointAxes{{place.azimuth, 60_deg}}));
    bench.run(Seconds(30.0));
    EXPECT_EQ(bench.box().starts(Axis::Azimuth), azimuth);
    EXPECT_NEAR(bench.truth().elevation.degrees(), 60.0, 2.6);
    const int elevation = bench.box().starts(Axis::Elevation);
    ASSERT_TRUE(bench.ask(request::PointAxes{{150_deg, bench.mount().measured()->elevation}}));
    bench.run(Seconds(30.0));
    EXPECT_EQ(bench.box().starts(Axis::Elevation), elevation);
}

// REQ-GS232-32 (Gs232Starts.ALongCoast*, SwitchedMotorTest.StopsEarlierByItsCoast): A rotator that coasts far is
// stopped earlier by what it coasted before.
TEST(Gs232Starts, ALongCoastIsMeasuredAndAllowedFor)
{
    Gs232Bench bench(gs232Profile(), Gs232Box::Habits{.coast = Angle::fromDegrees(2.5)});
    bench.run(Seconds(2.0));
    double azimuth = 30.0;
    for (int slew = 0; slew < 5; ++slew, azimuth += 30.0) {
        ASSERT_TRUE(bench.goTo(azimuth, 20.0 + 8.0 * slew));
        bench.run(Seconds(60.0));
    }
    bench.expectAt({Angle::fromDegrees(150.0), 52_deg}, {}, 1_deg);
    EXPECT_LE(bench.box().starts(Axis::Azimuth), 7);
    EXPECT_FALSE(bench.control().faultLatched());
}

}  // namespace
}  // namespace boresight::gs232
