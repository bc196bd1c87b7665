// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cross_check/ampere_link.h"

#include "tests/fakes/manual_clock.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace boresight {
namespace {

// One value a second, measured about half a second earlier. Every ten seconds the current changes between 0.2 and
// `amperes`.
std::optional<CurrentCorrelation> after(double seconds, double amperes,
                                        const std::function<double(double amperes, double second)>& degrees)
{
    fakes::ManualClock clock;
    AmpereLink link;
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0.0, 0.5);
    const auto at = [amperes](double second) { return static_cast<int>(second / 10.0) % 2 == 0 ? 0.2 : amperes; };
    for (int tick = 1; tick <= static_cast<int>(seconds * 50.0); ++tick) {
        clock.advance(Seconds(0.02));
        const double second = tick / 50.0;
        link.note(clock.now(), at(second));
        if (tick % 50 == 0) {
            link.take(clock.now() - std::chrono::milliseconds(500), Seconds(0.2),
                      Angle::fromDegrees(degrees(at(second - 0.5), second) + noise(random)));
        }
    }
    return link.correlation();
}

// REQ-WITNESS-45 (AmpereLink.*): A difference that varies with the motor current is reported as such, in degrees per
// ampere. The last minute must show it clearly: 15 values, a current that rose and fell, a correlation of 0.8. It moves
// and stores nothing.
TEST(AmpereLink, ADisturbanceThatGoesWithTheCurrentIsFound)
{
    const auto found = after(60.0, 3.2, [](double amperes, double) { return 2.0 + 5.0 * amperes; });
    ASSERT_TRUE(found);
    EXPECT_GT(found->coefficient, 0.95);
    EXPECT_NEAR(found->perAmpere.degrees(), 5.0, 0.3);
    const auto backwards = after(60.0, 3.2, [](double amperes, double) { return -5.0 * amperes; });
    ASSERT_TRUE(backwards);
    EXPECT_LT(backwards->coefficient, -0.95);
}

TEST(AmpereLink, WhatDoesNotGoWithItIsNot)
{
    EXPECT_FALSE(after(60.0, 3.2, [](double, double) { return 14.0; })) << "only noise changes";
    EXPECT_FALSE(after(60.0, 3.2, [](double, double second) { return second > 30.0 ? 14.0 : 0.0; })) << "steel";
    EXPECT_FALSE(after(60.0, 3.2, [](double, double second) { return second / 3.0; })) << "a drift";
}

TEST(AmpereLink, OneRiseOfTheCurrentProvesNothing)
{
    EXPECT_FALSE(after(20.0, 3.2, [](double amperes, double) { return 5.0 * amperes; })) << "the motion may be it";
}

TEST(AmpereLink, ACurrentThatHardlyChangesProvesNothing)
{
    EXPECT_FALSE(after(60.0, 0.4, [](double amperes, double) { return 50.0 * amperes; }));
}

TEST(AmpereLink, TheLastMinuteCounts)
{
    const auto early = [](double amperes, double second) { return second < 60.0 ? 5.0 * amperes : 0.0; };
    EXPECT_TRUE(after(60.0, 3.2, early));
    EXPECT_FALSE(after(125.0, 3.2, early));
}

}  // namespace
}  // namespace boresight
