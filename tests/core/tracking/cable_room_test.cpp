// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/cable_room.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace boresight::tracking {
namespace {

WholeTurns turnsOf(std::initializer_list<double> azimuths, const TravelRange& range)
{
    SweptArc arc;
    for (const double azimuth : azimuths) {
        arc.add(Angle::fromDegrees(azimuth));
    }
    return arc.turnsInside(range);
}

// REQ-TRACKING-17: The azimuth of a path is counted through north without a jump, and the wraps of the cable that have
// room for the whole path are known.
TEST(CableRoom, APathThroughNorthIsOneArc)
{
    const WholeTurns found = turnsOf({340.0, 350.0, 0.0, 10.0, 60.0}, {-90_deg, 450_deg});
    EXPECT_EQ(found.first, -1) << "-20° to 60°";
    EXPECT_EQ(found.last, 0) << "340° to 420°";
    EXPECT_FALSE(turnsOf({340.0, 350.0, 0.0, 10.0}, {0_deg, 360_deg}).any());
    EXPECT_TRUE(turnsOf({10.0, 170.0, 330.0}, {0_deg, 360_deg}).any());
}

TEST(CableRoom, AnArcMayReachBothEnds)
{
    const WholeTurns found = turnsOf({0.0, 120.0, 240.0, 360.0}, {0_deg, 360_deg});
    EXPECT_EQ(found.first, 0);
    EXPECT_EQ(found.last, 0);
    EXPECT_FALSE(turnsOf({}, {0_deg, 360_deg}).any());
}

TEST(CableRoom, AFullTurnTakesItsWayAndItsRamps)
{
    EXPECT_NEAR(
        fullTurnTime({.speed = 10_deg_s, .acceleration = AngularAcceleration::fromDegrees(5.0), .jerk = {}}).count(),
        38.0, 1e-9);
}

}  // namespace
}  // namespace boresight::tracking
