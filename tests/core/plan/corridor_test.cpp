// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/corridor.h"

#include "core/plan/state_set.h"

#include <gmock/gmock.h>

#include <cmath>

namespace boresight::plan {
namespace {

using tracking::MotionBounds;
using tracking::MotionState;

constexpr MotionBounds kBounds{.speed = 2.0, .acceleration = 4.0};
constexpr double kTick = 0.1;

// A wide corridor around 0 in which the axis has to be beyond `there` from one moment on.
std::vector<Gate> gatesTo(double there, int from, int count)
{
    std::vector<Gate> gates;
    for (int i = 0; i < count; ++i) {
        gates.push_back({.seconds = i * kTick, .low = i < from ? -100.0 : there, .high = 100.0, .wish = {}});
    }
    return gates;
}

}  // namespace

// From standstill the axis needs 0.5 s to its speed and covers 0.5 in this time. After 2 s it is at 3.5.
// REQ-PLAN-03: A way through a corridor keeps speed and acceleration, and is found exactly if there is one.
TEST(Corridor, IsPassedIfAndOnlyIfTheAxisIsFastEnough)
{
    const WayEnds ends{.first = MotionState{}, .last = {}};
    EXPECT_TRUE(hasWay(gatesTo(3.499, 20, 30), ends, kBounds));
    EXPECT_FALSE(hasWay(gatesTo(3.501, 20, 30), ends, kBounds));
    EXPECT_TRUE(wayThrough(gatesTo(3.499, 20, 30), ends, kBounds));
    EXPECT_FALSE(wayThrough(gatesTo(3.501, 20, 30), ends, kBounds));
}

// REQ-PLAN-03
TEST(Corridor, TheWayIsAMotionOfTheAxis)
{
    const std::vector<Gate> gates = gatesTo(3.4, 20, 60);
    const WayEnds ends{.first = MotionState{}, .last = MotionState{3.6, 0.0}};
    const auto way = wayThrough(gates, ends, kBounds);
    ASSERT_TRUE(way);
    EXPECT_NEAR(way->front().position, 0.0, 1e-6);
    EXPECT_EQ(way->back().position, 3.6);
    for (std::size_t i = 1; i < way->size(); ++i) {
        const MotionState& from = (*way)[i - 1];
        const MotionState& to = (*way)[i];
        EXPECT_LE(std::abs(to.rate), kBounds.speed + 1e-6);
        EXPECT_LE(std::abs(to.rate - from.rate), kBounds.acceleration * kTick + 1e-6);
        EXPECT_NEAR(to.position - from.position, 0.5 * (from.rate + to.rate) * kTick, 1e-6) << i;
        EXPECT_GE(to.position, gates[i].low - 1e-6);
    }
}

TEST(Corridor, AWishThatTheAxisCanFollowIsFollowed)
{
    std::vector<Gate> gates;
    for (int i = 0; i < 100; ++i) {
        const double seconds = i * kTick;
        gates.push_back({.seconds = seconds,
                         .low = -9.0,
                         .high = 9.0,
                         .wish = {.position = std::sin(seconds), .rate = std::cos(seconds)}});
    }
    const auto way = wayThrough(gates, {.first = gates.front().wish, .last = gates.back().wish}, kBounds);
    ASSERT_TRUE(way);
    for (std::size_t i = 0; i < way->size(); ++i) {
        EXPECT_NEAR((*way)[i].position, gates[i].wish.position, 0.002) << i;
    }
}

TEST(Corridor, IsClosedWhereItHasNoWidth)
{
    std::vector<Gate> gates = gatesTo(0.0, 5, 10);
    gates[7].low = gates[7].high + 1.0;
    EXPECT_FALSE(hasWay(gates, {}, kBounds));
    EXPECT_FALSE(wayThrough(gates, {}, kBounds));
}

TEST(StateSet, GrowsByWhatTheAccelerationsAdd)
{
    const StateSet now = StateSet::only({1.0, 0.5});
    const StateSet later = now.later(1.0, 2.0).later(1.0, 2.0);
    EXPECT_TRUE(later.contains({2.0, 0.5}));
    EXPECT_TRUE(later.contains({2.0 + 3.99, 0.5 + 3.99})) << "full acceleration for 2 s";
    EXPECT_FALSE(later.contains({2.0 + 4.01, 0.5 + 4.01}));
    EXPECT_TRUE(later.contains({2.0 + 1.99, 0.5})) << "faster, then slower";
    EXPECT_FALSE(later.contains({2.0 + 2.01, 0.5}));
    EXPECT_TRUE(later.within(3.0, 2.0, 9.0).empty());
}

}  // namespace boresight::plan
