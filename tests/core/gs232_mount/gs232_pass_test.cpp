// SPDX-License-Identifier: GPL-3.0-or-later
// A pass followed by a GS-232 rotator: how well, and at what cost in commands and motor starts.
#include "tests/core/gs232_mount/gs232_bench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <numbers>
#include <string>

namespace boresight::gs232 {
namespace {

// Of a satellite that culminates at 57° in the south, eight minutes long.
AxisPosition passAt(double seconds)
{
    const double half = std::numbers::pi * seconds / 480.0;
    return {.azimuth = Angle::fromDegrees(180.0 - 80.0 * std::cos(half)),
            .elevation = Angle::fromDegrees(2.0 + 55.0 * std::sin(half))};
}

// The two minutes around its culmination, where the azimuth is fastest.
constexpr int kFrom = 180;
constexpr int kTo = 300;
constexpr double kMinutes = (kTo - kFrom) / 60.0;

struct Tally
{
    double worst = 0.0;  // degrees
    double sum = 0.0;
    int looks = 0;
};

struct Outcome
{
    std::array<Tally, 2> axes;
    double commands = 0.0;            // per second, questions included
    double targets = 0.0;             // per minute
    double starts = 0.0;              // per minute, of both motors
    std::array<int, 2> mostStarts{};  // of one motor within a minute, as reported
    bool fault = false;
};

// As a client follows it: one target a second.
Outcome follow(Gs232Bench& bench)
{
    const auto ask = [&bench](int second) {
        return bench.control().request(request::PointAxes{passAt(second)}, kClient);
    };
    bench.run(Seconds(2.0));
    for (int second = kFrom - 60; second < kFrom; ++second) {
        EXPECT_TRUE(ask(second));
        bench.run(Seconds(1.0));
    }
    const auto sent = bench.mount().talk().counts().sent;
    const int starts = bench.box().starts();
    const int moves = bench.box().moves();
    Outcome outcome;
    for (int second = kFrom; second < kTo; ++second) {
        EXPECT_TRUE(ask(second));
        for (int part = 0; part < 10; ++part) {
            bench.run(Seconds(0.1));
            for (const Axis axis : kAxes) {
                Tally& tally = outcome.axes[index(axis)];
                const double away =
                    abs(of(axis, bench.truth()) - of(axis, passAt(second + 0.1 * (part + 1)))).degrees();
                tally.worst = std::max(tally.worst, away);
                tally.sum += away;
                ++tally.looks;
            }
        }
        for (const Axis axis : kAxes) {
            int& most = outcome.mostStarts[index(axis)];
            most = std::max(most, bench.mount().report(axis).starts->lastMinute);
        }
    }
    outcome.commands = static_cast<double>(bench.mount().talk().counts().sent - sent) / (kTo - kFrom);
    outcome.targets = (bench.box().moves() - moves) / kMinutes;
    outcome.starts = (bench.box().starts() - starts) / kMinutes;
    outcome.fault = bench.control().faultLatched();
    return outcome;
}

void print(const std::string& name, double beam, const Outcome& of)
{
    std::cout << "| " << name << " | " << beam << "° | ";
    for (const Tally& tally : of.axes) {
        std::cout << tally.sum / tally.looks << "° | " << tally.worst << "° | " << tally.worst / beam << " | ";
    }
    std::cout << of.commands << " | " << of.targets << " | " << of.starts << " |\n";
}

profile::Profile withBeam(double degrees)
{
    profile::Profile profile = gs232Profile();
    profile.mount.beamWidth = Angle::fromDegrees(degrees);
    return profile;
}

// REQ-GS232-30: A pass is followed within the dead band: half the beam width, and at least one degree. The rotator is
// sent ahead of the target, which then passes through the beam. It gets at most six commands a second.
TEST(Gs232Pass, IsFollowedWithinTheDeadBand)
{
    for (const double beam : {2.0, 5.0, 10.0, 20.0}) {
        Gs232Bench bench(withBeam(beam));
        const Outcome outcome = follow(bench);
        print("a pass, beam", beam, outcome);
        const double deadBand = std::max(beam / 2.0, 1.0);
        for (const Tally& tally : outcome.axes) {
            EXPECT_LT(tally.worst, deadBand + 1.5) << beam << "° wide";
            EXPECT_LT(tally.sum / tally.looks, deadBand);
        }
        EXPECT_LT(outcome.commands, 6.0);
        EXPECT_LT(outcome.starts, 60.0 / beam) << beam << "° wide";
        EXPECT_FALSE(outcome.fault);
    }
}

// REQ-GS232-31: A motor is not started more often in a minute than the profile permits. What that costs in error passes
// with the minute, and ends no motion.
TEST(Gs232Pass, HasNoMoreStartsThanPermitted)
{
    profile::Profile profile = withBeam(2.0);
    profile.control.startsPerMinute = 4;
    Gs232Bench bench(profile);
    const Outcome outcome = follow(bench);
    print("four starts a minute, beam", 2.0, outcome);
    EXPECT_LE(outcome.mostStarts[0], 4);
    EXPECT_LE(outcome.mostStarts[1], 4);
    EXPECT_LE(outcome.starts, 8.0);
    EXPECT_FALSE(outcome.fault);
    bench.run(Seconds(90.0));
    bench.expectAt(passAt(kTo - 1), {}, 1_deg);
}

// REQ-GS232-32: The operator sets the dead band.
TEST(Gs232Pass, TheDeadBandCanBeSet)
{
    profile::Profile profile = withBeam(20.0);
    profile.control.deadBand = 2_deg;
    Gs232Bench bench(profile);
    const Outcome outcome = follow(bench);
    EXPECT_LT(outcome.axes[0].worst, 3.5);
    EXPECT_LT(outcome.axes[1].worst, 3.5);
}

// REQ-GS232-33: A slew is one target and one start of each motor, whatever the speed of the profile. The starts that
// are reported are those of the rotator.
TEST(Gs232Slew, IsOneTargetAndOneStartOfEachMotor)
{
    for (const double speed : {2.5, 5.0, 6.0}) {
        profile::Profile profile = gs232Profile();
        profile.azimuth.limits.speed = profile.elevation.limits.speed = AngularRate::fromDegrees(speed);
        Gs232Bench bench(profile);
        bench.run(Seconds(2.0));
        ASSERT_TRUE(bench.goTo(100.0, 80.0));
        bench.run(Seconds(60.0));
        bench.expectAt({100_deg, 80_deg}, {}, 1_deg);
        EXPECT_EQ(bench.control().state(), StationState::Hold);
        EXPECT_EQ(bench.box().starts(), 2);
        EXPECT_EQ(bench.box().moves(), 1);
        EXPECT_EQ(bench.heardOf("W100 080"), 1);
        for (const Axis axis : kAxes) {
            EXPECT_EQ(bench.mount().report(axis).starts->total, 1U);
        }
    }
}

// REQ-GS232-34: A rotator that was sent far and is wanted elsewhere stops where it is. It never turns back to where its
// set-point has come meanwhile.
TEST(Gs232Slew, ThatIsEndedStopsWhereItIs)
{
    profile::Profile profile = gs232Profile();
    profile.azimuth.limits.speed = 2_deg_s;  // the rotator has 6
    Gs232Bench bench(profile);
    bench.run(Seconds(2.0));
    ASSERT_TRUE(bench.goTo(200.0, 20.0));
    bench.run(Seconds(15.0));
    const Angle at = bench.truth().azimuth;
    ASSERT_GT(at, 80_deg) << "far ahead of its set-point";
    ASSERT_TRUE(bench.ask(request::Hold{}));
    bench.run(Seconds(1.0));
    EXPECT_EQ(bench.heardOf("S"), 1);
    bench.run(Seconds(10.0));
    EXPECT_NEAR(bench.truth().azimuth.degrees(), at.degrees(), 5.0);
    EXPECT_GE(bench.truth().azimuth, at - 1_deg);
    EXPECT_TRUE(bench.stands(Seconds(10.0)));
    EXPECT_FALSE(bench.control().faultLatched());
    ASSERT_TRUE(bench.goTo(150.0, 20.0));
    bench.run(Seconds(60.0));
    bench.expectAt({150_deg, 20_deg}, {}, 1_deg);
}

// REQ-GS232-34
TEST(Gs232Slew, ToAnotherTargetBeginsWhereTheRotatorIs)
{
    profile::Profile profile = gs232Profile();
    profile.azimuth.limits.speed = 2_deg_s;
    Gs232Bench bench(profile);
    bench.run(Seconds(2.0));
    ASSERT_TRUE(bench.goTo(300.0, 20.0));
    bench.run(Seconds(20.0));
    const Angle at = bench.truth().azimuth;
    ASSERT_GT(at, 110_deg);
    ASSERT_TRUE(bench.goTo(60.0, 40.0));
    bench.run(Seconds(60.0));
    bench.expectAt({60_deg, 40_deg}, {}, 1_deg);
    EXPECT_FALSE(bench.control().faultLatched());
}

// REQ-GS232-35: A keep-out in between is driven around, as by a rotator that follows its set-points.
TEST(Gs232Slew, LeadsAroundAKeepOut)
{
    for (const double speed : {2.0, 6.0}) {
        profile::Profile profile = gs232Profile();
        profile.azimuth.limits.speed = profile.elevation.limits.speed = AngularRate::fromDegrees(speed);
        profile.limits.keepOuts = {{.name = "mast",
                                    .azimuthFrom = 80_deg,
                                    .azimuthTo = 100_deg,
                                    .elevationMin = 0_deg,
                                    .elevationMax = 50_deg}};
        Gs232Bench bench(profile);
        bench.run(Seconds(2.0));
        ASSERT_TRUE(bench.goTo(160.0, 10.0));
        for (int tick = 0; tick < 6000; ++tick) {
            bench.tick();
            const AxisPosition at = bench.truth();
            ASSERT_FALSE(at.azimuth > 81_deg && at.azimuth < 99_deg && at.elevation < 49_deg)
                << at.azimuth.degrees() << "° " << at.elevation.degrees() << "°";
        }
        bench.expectAt({160_deg, 10_deg}, {}, 1_deg);
        EXPECT_LE(bench.box().starts(), 8);
    }
}

}  // namespace
}  // namespace boresight::gs232
