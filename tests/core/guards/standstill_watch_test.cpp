// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/guards/standstill_watch.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

using namespace boresight::literals;

class StandstillWatchTest : public testing::Test
{
protected:
    // Makes one report after each `pause`. Each report is `step` farther than the last.
    void turn(int reports, Angle step, std::chrono::milliseconds pause = std::chrono::milliseconds(20))
    {
        for (int i = 0; i < reports; ++i) {
            m_now += pause;
            m_place += step;
            look();
        }
    }
    void look(bool changesHands = false)
    {
        watch.look(Axis::Azimuth, {.changesHands = changesHands, .place = m_place, .placed = m_now});
    }

    StandstillWatch watch;
    Angle m_place = 100_deg;
    SteadyTime m_now{};
};

TEST_F(StandstillWatchTest, AnAxisMovesUntilItHasStoodForASecond)
{
    EXPECT_FALSE(watch.moves(Axis::Azimuth)) << "nothing was reported";
    turn(50, 0.003_deg);  // 0.15°/s
    EXPECT_TRUE(watch.moves(Axis::Azimuth));
    EXPECT_FALSE(watch.moves(Axis::Elevation));
    turn(10, 0_deg);
    EXPECT_TRUE(watch.moves(Axis::Azimuth));
    turn(50, 0_deg);
    EXPECT_FALSE(watch.moves(Axis::Azimuth));
}

TEST_F(StandstillWatchTest, TheNoiseOfAnEncoderIsNoMotion)
{
    for (int i = 0; i < 100; ++i) {
        turn(1, i % 2 == 0 ? 0.066_deg : -0.066_deg);  // three counts of 16384
        EXPECT_FALSE(watch.moves(Axis::Azimuth));
    }
}

TEST_F(StandstillWatchTest, ARotatorOfWholeDegreesMovesBetweenItsReports)
{
    turn(4, 1_deg, std::chrono::milliseconds(500));
    EXPECT_TRUE(watch.moves(Axis::Azimuth));
    look();  // the station reads the same report again in the next tick
    EXPECT_TRUE(watch.moves(Axis::Azimuth));
}

TEST_F(StandstillWatchTest, AnotherNumberForTheSamePlaceIsNoMotion)
{
    turn(10, 0_deg);
    m_place += 360_deg;
    look(true);
    turn(10, 0_deg);
    EXPECT_FALSE(watch.moves(Axis::Azimuth));
    watch.forget();
    turn(1, 360_deg);
    EXPECT_FALSE(watch.moves(Axis::Azimuth));
}

}  // namespace
}  // namespace boresight
