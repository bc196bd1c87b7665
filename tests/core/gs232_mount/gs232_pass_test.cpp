// SPDX-License-Identifier: GPL-3.0-or-later
// A GS-232 rotator tracks a pass: its error, and the number of commands and motor starts.
#include "tests/core/gs232_mount/gs232_bench.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <numbers>

namespace boresight::gs232 {
namespace {

// The position of a satellite that culminates at 57° in the south and is up for eight minutes.
AxisPosition passAt(double seconds)
{
    const double half = std::numbers::pi * seconds / 480.0;
    return {.azimuth = Angle::fromDegrees(180.0 - 80.0 * std::cos(half)),
            .elevation = Angle::fromDegrees(2.0 + 55.0 * std::sin(half))};
}

// s: the two minutes around the culmination, where the azimuth is fastest.
constexpr int kFrom = 180;
constexpr int kTo = 300;
constexpr double kMinutes = (kTo - kFrom) / 60.0;

struct Tally
{
    double worst = 0.0;  // degrees
    double sum = 0.0;
    int looks = 0;
};

// REQ-GS232-30: A rotator with whole degrees tracks a pass within 1.5°. It receives at most six commands a second.
TEST(Gs232Pass, IsFollowedWithFewCommands)
{
    Gs232Bench bench;
    bench.run(Seconds(2.0));
    ASSERT_TRUE(bench.ask(request::PointAxes{passAt(kFrom)}));
    bench.run(Seconds(40.0));
    const auto heard = bench.mount().talk().counts().sent;
    const int starts = bench.box().starts();
    const int moves = bench.box().moves();
    Tally azimuth;
    Tally elevation;
    for (int second = kFrom; second < kTo; ++second) {
        ASSERT_TRUE(bench.ask(request::PointAxes{passAt(second)}));
        bench.run(Seconds(1.0));
        for (const Axis axis : kAxes) {
            Tally& tally = axis == Axis::Azimuth ? azimuth : elevation;
            const double away = abs(of(axis, bench.truth()) - of(axis, passAt(second))).degrees();
            tally.worst = std::max(tally.worst, away);
            tally.sum += away;
            ++tally.looks;
        }
    }
    const double commands = static_cast<double>(bench.mount().talk().counts().sent - heard) / (kTo - kFrom);
    std::cout << "| pass | worst az | worst el | mean az | mean el | commands/s | targets/min | motor starts/min |\n| "
                 "GS-232 | "
              << azimuth.worst << "° | " << elevation.worst << "° | " << azimuth.sum / azimuth.looks << "° | "
              << elevation.sum / elevation.looks << "° | " << commands << " | "
              << (bench.box().moves() - moves) / kMinutes << " | " << (bench.box().starts() - starts) / kMinutes
              << " |\n";
    EXPECT_LT(azimuth.worst, 1.5);
    EXPECT_LT(elevation.worst, 1.5);
    EXPECT_LT(commands, 6.0);
    EXPECT_FALSE(bench.control().faultLatched());
}

// While the set-points move as fast as the rotator, the motors run without a pause. They start again only in the ramps.
TEST(Gs232Pass, ASlewHasFewMotorStarts)
{
    Gs232Bench bench;
    bench.run(Seconds(2.0));
    ASSERT_TRUE(bench.goTo(100.0, 80.0));
    bench.run(Seconds(40.0));
    bench.expectAt({100_deg, 80_deg}, {}, 1_deg);
    EXPECT_LE(bench.box().starts(), 30);
    std::cout << "a slew of 90°: " << bench.box().starts() << " motor starts, " << bench.box().moves() << " targets\n";
}

}  // namespace
}  // namespace boresight::gs232
