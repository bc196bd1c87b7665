// SPDX-License-Identifier: GPL-3.0-or-later
// A pass followed by a GS-232 rotator: how well, and at what cost in commands and motor starts.
#include "core/base/numbers.h"
#include "core/units/angle_between.h"
#include "tests/core/gs232_mount/gs232_bench.h"
#include "tests/fakes/reference_data.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace boresight::gs232 {
namespace {

struct Timed
{
    double time = 0.0;  // s
    AxisPosition position;
};

// Rows of one key: key columns, then time, azimuth, elevation.
std::vector<Timed> rowsOf(const std::string& file, const std::vector<std::string>& keys)
{
    std::vector<Timed> rows;
    for (const std::vector<std::string>& row : fakes::referenceRows(file)) {
        if (std::equal(keys.begin(), keys.end(), row.begin())) {
            const auto number = [&](std::size_t column) { return *parseFinite(row.at(keys.size() + column)); };
            rows.push_back({number(0), {Angle::fromDegrees(number(1)), Angle::fromDegrees(number(2))}});
        }
    }
    return rows;
}

// What Gpredict sent for a pass of the ISS that culminates at 45°, and where the ISS was. The middle of it.
constexpr double kFrom = 230.0;
constexpr double kTo = 430.0;
constexpr double kMinutes = (kTo - kFrom) / 60.0;

struct Tally
{
    double worst = 0.0;  // degrees
    double sum = 0.0;
    int looks = 0;

    void add(double away)
    {
        worst = std::max(worst, away);
        sum += away;
        ++looks;
    }
};

struct Outcome
{
    std::array<Tally, 2> axes;
    Tally beam;                       // angle in the sky
    Tally seen;                       // the same as measured
    double commands = 0.0;            // per second, questions included
    double targets = 0.0;             // per minute
    double starts = 0.0;              // per minute, of both motors
    std::array<int, 2> mostStarts{};  // of one motor within a minute, as reported
    int offTarget = 0;                // ticks in which the state was not Track
    bool fault = false;
};

SkyPointing skyOf(const AxisPosition& place)
{
    return {.azimuth = place.azimuth.wrapped360(), .elevation = place.elevation};
}

void look(Gs232Bench& bench, const AxisPosition& real, Outcome& outcome)
{
    for (const Axis axis : kAxes) {
        outcome.axes[index(axis)].add(abs(of(axis, bench.truth()) - of(axis, real)).degrees());
        int& most = outcome.mostStarts[index(axis)];
        most = std::max(most, bench.mount().report(axis).starts->lastMinute);
    }
    outcome.beam.add(angleBetween(skyOf(bench.truth()), skyOf(real)).degrees());
    if (const auto target = bench.control().status().target) {
        outcome.seen.add(angleBetween(skyOf(*bench.mount().measured()), *target).degrees());
    }
    outcome.offTarget += bench.control().state() == StationState::Track ? 0 : 1;
}

Outcome follow(Gs232Bench& bench)
{
    const std::vector<Timed> stream = rowsOf("track_streams.csv", {"A45", "gp_0.1"});
    const std::vector<Timed> truth = rowsOf("track_truth.csv", {"A45"});
    bench.run(Seconds(2.0));
    Outcome outcome;
    std::uint64_t sent = 0;
    int starts = 0;
    int moves = 0;
    auto next = std::ranges::find_if(stream, [](const Timed& one) { return one.time >= kFrom - 60.0; });
    for (double time = kFrom - 60.0; time < kTo; time += 0.2) {
        for (; next != stream.end() && next->time <= time; ++next) {
            EXPECT_TRUE(bench.control().request(request::PointAxes{next->position}, kClient));
        }
        bench.control().positionRead(kClient.clientId);
        bench.run(Seconds(0.2));
        const auto at = static_cast<std::size_t>(std::lround((time + 0.2) / 0.2));
        if (time < kFrom) {
            sent = bench.mount().talk().counts().sent;
            starts = bench.box().starts();
            moves = bench.box().moves();
        } else {
            look(bench, truth.at(at).position, outcome);
        }
    }
    outcome.commands = static_cast<double>(bench.mount().talk().counts().sent - sent) / (kTo - kFrom);
    outcome.targets = (bench.box().moves() - moves) / kMinutes;
    outcome.starts = (bench.box().starts() - starts) / kMinutes;
    outcome.fault = bench.control().faultLatched();
    return outcome;
}

void print(const std::string& name, const Outcome& of)
{
    std::cout << "| " << name << " | ";
    for (const Tally& tally : {of.axes[0], of.axes[1], of.beam}) {
        std::cout << tally.sum / tally.looks << "° | " << tally.worst << "° | ";
    }
    std::cout << of.commands << " | " << of.targets << " | " << of.starts << " | " << of.mostStarts[0] << " "
              << of.mostStarts[1] << " |\n";
}

profile::Profile withBeam(double degrees)
{
    profile::Profile profile = gs232Profile();
    profile.mount.beamWidth = Angle::fromDegrees(degrees);
    return profile;
}

// REQ-GS232-30 (Gs232Pass.*, SwitchedMotorTest.StartsOfAMinuteAreLimitedAndSpread): A pass is followed with few starts
// of the motors, while the satellite stays in the beam. A motor is not started more often in a minute than the profile
// permits. The rotator gets at most six commands a second.
TEST(Gs232Pass, IsFollowedWithinTheBeam)
{
    for (const double beam : {10.0, 20.0}) {
        Gs232Bench bench(withBeam(beam));
        const Outcome outcome = follow(bench);
        print("beam " + std::to_string(static_cast<int>(beam)) + "°", outcome);
        EXPECT_LT(outcome.beam.worst, beam / 2.0);
        EXPECT_LT(outcome.commands, 6.0);
        EXPECT_LT(outcome.starts, 100.0 / beam);
        EXPECT_LT(outcome.offTarget, 50) << "of 1000 looks";
        EXPECT_FALSE(outcome.fault);
    }
}

// REQ-GS232-30
TEST(Gs232Pass, ANarrowBeamHasNoMoreStartsThanPermitted)
{
    profile::Profile profile = withBeam(2.0);
    profile.control.startsPerMinute = 6;
    Gs232Bench bench(profile);
    const Outcome outcome = follow(bench);
    print("beam 2°, 6 starts", outcome);
    EXPECT_LE(*std::ranges::max_element(outcome.mostStarts), 6);
    EXPECT_FALSE(outcome.fault);
}

// REQ-GS232-38: With an output for a transmitter the dead band is small enough for it: the output is never switched off
// because the rotator waits.
TEST(Gs232Pass, KeepsTheTransmitterOn)
{
    profile::Profile profile = withBeam(12.0);
    profile.transmit.output = "file:/nowhere/transmit";
    profile.control.startsPerMinute = 30;
    Gs232Bench bench(profile);
    const Outcome outcome = follow(bench);
    print("beam 12°, transmitting", outcome);
    EXPECT_LT(outcome.seen.worst, profile.transmit.beamFraction * 12.0);
    EXPECT_EQ(outcome.offTarget, 0);
}

// REQ-GS232-33 (Gs232Slew.*, SwitchedMotorTest.APlaceIsMetOnce, SwitchedMotorTest.ALongWayIsOneStartInPieces): A slew
// is one start of each motor, whatever the speed of the profile. The rotator is sent on piece by piece while it runs,
// so it never runs farther than 12° when the line fails. At its place it is left alone.
TEST(Gs232Slew, IsOneStartOfEachMotor)
{
    for (const double speed : {2.5, 6.0}) {
        profile::Profile profile = gs232Profile();
        profile.azimuth.limits.speed = profile.elevation.limits.speed = AngularRate::fromDegrees(speed);
        Gs232Bench bench(profile);
        bench.run(Seconds(2.0));
        ASSERT_TRUE(bench.goTo(100.0, 80.0));
        bench.run(Seconds(40.0));
        bench.expectAt({100_deg, 80_deg}, {}, 1_deg);
        EXPECT_EQ(bench.control().state(), StationState::Hold);
        EXPECT_LE(bench.box().moves(), 25);
        for (const Axis axis : kAxes) {
            EXPECT_EQ(bench.box().starts(axis), 1);
            EXPECT_EQ(bench.mount().report(axis).starts->total, 1U);
        }
    }
}

}  // namespace
}  // namespace boresight::gs232
