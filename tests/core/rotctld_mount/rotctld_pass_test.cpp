// SPDX-License-Identifier: GPL-3.0-or-later
// The dummy rotator of Hamlib tracks a pass: its error, and the number of commands.
#include "tests/core/rotctld_mount/rotctld_bench.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <numbers>

namespace boresight::rotctl {
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

// REQ-ROTCTLDMOUNT-30: An exact rotator tracks a pass within 0.6°. rotctld receives at most six commands a second.
TEST(RotctldPass, IsFollowedWithFewCommands)
{
    RotctldBench bench;
    bench.run(Seconds(2.0));
    ASSERT_TRUE(bench.ask(request::PointAxes{passAt(kFrom)}));
    bench.run(Seconds(40.0));
    const auto sent = bench.mount().talk().counts().sent;
    double worst = 0.0;
    double sum = 0.0;
    for (int second = kFrom; second < kTo; ++second) {
        ASSERT_TRUE(bench.ask(request::PointAxes{passAt(second)}));
        bench.run(Seconds(1.0));
        for (const Axis axis : kAxes) {
            const double away = abs(of(axis, bench.truth()) - of(axis, passAt(second))).degrees();
            worst = std::max(worst, away);
            sum += away;
        }
    }
    const double commands = static_cast<double>(bench.mount().talk().counts().sent - sent) / (kTo - kFrom);
    std::cout << "| pass | worst | mean | commands/s |\n| rotctld | " << worst << "° | " << sum / (2.0 * (kTo - kFrom))
              << "° | " << commands << " |\n";
    EXPECT_LT(worst, 0.6);
    EXPECT_LT(commands, 6.0);
    EXPECT_FALSE(bench.control().faultLatched());
}

}  // namespace
}  // namespace boresight::rotctl
