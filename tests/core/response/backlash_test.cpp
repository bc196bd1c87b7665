// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/response/backlash.h"

#include "tests/core/response/reason_of.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>
#include <vector>

namespace boresight::response {
namespace {

using ::testing::HasSubstr;

struct Gear
{
    double gap = 0.02;         // degrees
    double motorFriction = 2;  // Nm
    double loadFriction = 3;   // Nm
    double noise = 0.3;        // Nm
    double sense = 1.0;        // of the reported torque
    int legs = 9;
    double rate = 0.05;  // °/s
    double leg = 0.3;    // degrees
};

// A motor that moves back and forth behind a gear with play. The load stands still until the motor meets it.
std::vector<Sample> movedBy(const Gear& gear)
{
    constexpr double kTick = 0.02;
    constexpr double kCount = 360.0 / 65536.0;
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0.0, gear.noise);
    std::vector<Sample> samples;
    double place = 0.0;
    double lag = 0.0;  // load behind motor, within half the gap
    const int each = static_cast<int>(gear.leg / gear.rate / kTick);
    for (int i = 0; i < each * gear.legs; ++i) {
        const double way = (i / each) % 2 == 0 ? 1.0 : -1.0;
        place += way * gear.rate * kTick;
        lag = std::clamp(lag - way * gear.rate * kTick, -gear.gap / 2.0, gear.gap / 2.0);
        const bool carries = std::abs(-way * gear.gap / 2.0 - lag) < 1e-9;
        const double torque = gear.motorFriction + (carries ? gear.loadFriction : 0.0);
        samples.push_back({.time = Seconds(i * kTick),
                           .wanted = Angle::fromDegrees(place),
                           .actual = Angle::fromDegrees(std::floor(place / kCount) * kCount),
                           .torque = gear.sense * way * torque + noise(random)});
    }
    return samples;
}

// REQ-TUNING-05: The play of a gear is measured from the torque of slow legs back and forth, with its uncertainty.
TEST(Backlash, IsFoundWithinItsUncertainty)
{
    for (const double gap : {0.01, 0.02, 0.08, 0.15}) {
        const auto figures = backlashFigures(movedBy({.gap = gap}));
        ASSERT_TRUE(figures) << gap << reasonOf(figures);
        EXPECT_NEAR(figures->gap.degrees(), gap, figures->uncertainty.degrees());
        EXPECT_LT(figures->uncertainty.degrees(), 0.006);
        EXPECT_EQ(figures->reversals, 8);
    }
}

// REQ-TUNING-05
TEST(Backlash, TheTorquesAreThoseOfTheMotorAndOfTheLoad)
{
    const auto figures = backlashFigures(movedBy({.gap = 0.1, .sense = -1.0}));
    ASSERT_TRUE(figures) << reasonOf(figures);
    EXPECT_NEAR(figures->freeTorque, 2.0, 0.2);
    EXPECT_NEAR(figures->loadTorque, 5.0, 0.2);
}

// REQ-TUNING-06: If the torque does not show the play, the reason is reported instead of a number.
TEST(Backlash, SaysWhenItCannotBeTold)
{
    EXPECT_THAT(reasonOf(backlashFigures(movedBy({.gap = 0.0}))), HasSubstr("shows no gap"));
    EXPECT_THAT(reasonOf(backlashFigures(movedBy({.loadFriction = 0.0}))), HasSubstr("shows no gap"));
    EXPECT_THAT(reasonOf(backlashFigures(movedBy({.gap = 0.02, .loadFriction = 0.1, .noise = 1.0}))),
                HasSubstr("shows no gap"));
    EXPECT_THAT(reasonOf(backlashFigures(movedBy({.gap = 0.25}))), HasSubstr("larger than the movement"));
    EXPECT_THAT(reasonOf(backlashFigures(movedBy({.legs = 2}))), HasSubstr("too few times"));
    auto silent = movedBy({});
    silent[100].torque.reset();
    EXPECT_THAT(reasonOf(backlashFigures(silent)), HasSubstr("no torque"));
}

}  // namespace
}  // namespace boresight::response
