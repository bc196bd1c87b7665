// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/mount_model.h"

#include <gtest/gtest.h>

#include <random>

using namespace boresight;
using namespace boresight::pointing;

namespace {

const AxisGeometry kReferenceAzimuth{.travel = {-90_deg, 450_deg}};
const AxisGeometry kReferenceElevation{.sign = -1, .offset = 90_deg, .travel = {0_deg, 90_deg}};

}  // namespace

// The numbers of the reference mount, as its motors report them.
// REQ-POINTING-01: The reference mount: azimuth 0…360° is 0…1 turn, elevation 0° is -0.25 turn, 90° is -0.5 turn.
TEST(AxisGeometry, ReferenceMount)
{
    EXPECT_DOUBLE_EQ(kReferenceAzimuth.toMotor(0_deg).turns(), 0.0);
    EXPECT_DOUBLE_EQ(kReferenceAzimuth.toMotor(360_deg).turns(), 1.0);
    EXPECT_DOUBLE_EQ(kReferenceAzimuth.toMotor(-90_deg).turns(), -0.25);
    EXPECT_DOUBLE_EQ(kReferenceAzimuth.toMotor(450_deg).turns(), 1.25);
    EXPECT_DOUBLE_EQ(kReferenceElevation.toMotor(0_deg).turns(), -0.25);
    EXPECT_DOUBLE_EQ(kReferenceElevation.toMotor(45_deg).turns(), -0.375);
    EXPECT_DOUBLE_EQ(kReferenceElevation.toMotor(90_deg).turns(), -0.5);
    EXPECT_DOUBLE_EQ(kReferenceElevation.toMotor(36_deg_s).turns(), -0.1);
    EXPECT_DOUBLE_EQ(kReferenceElevation.toMotor(72_deg_s2).turns(), -0.2);
    EXPECT_DOUBLE_EQ(kReferenceElevation.toAxis(MotorTurns::fromTurns(-0.5)).degrees(), 90.0);
    EXPECT_DOUBLE_EQ(kReferenceElevation.toAxis(MotorRate::fromTurns(-0.1)).degrees(), 36.0);
}

// REQ-POINTING-02: The gear ratio is applied either in the host or in the drive, never twice.
TEST(AxisGeometry, GearRatioCountsInTheHostOnly)
{
    AxisGeometry gear{.sign = -1, .offset = 10_deg, .gearRatio = 60.0, .gearIn = GearIn::Host};
    EXPECT_DOUBLE_EQ(gear.toMotor(26_deg).turns(), -6.0);
    EXPECT_DOUBLE_EQ(gear.toMotor(6_deg_s).turns(), -1.0);
    gear.gearIn = GearIn::Drive;
    EXPECT_DOUBLE_EQ(gear.toMotor(26_deg).turns(), -0.1);
    EXPECT_DOUBLE_EQ(gear.toMotor(36_deg_s).turns(), -0.1);
}

// REQ-POINTING-03: The conversion to turns and back is exact to 1e-9°.
TEST(AxisGeometry, RoundTripIsExactToANanodegree)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> angle(-720.0, 720.0);
    std::uniform_real_distribution<double> ratio(0.01, 500.0);
    for (int i = 0; i < 10000; ++i) {
        const AxisGeometry geometry{.sign = i % 2 == 0 ? 1 : -1,
                                    .offset = Angle::fromDegrees(angle(random)),
                                    .gearRatio = ratio(random),
                                    .gearIn = i % 3 == 0 ? GearIn::Drive : GearIn::Host};
        const Angle there = Angle::fromDegrees(angle(random));
        ASSERT_NEAR(geometry.toAxis(geometry.toMotor(there)).degrees(), there.degrees(), 1e-9);
        const AngularRate rate = AngularRate::fromDegrees(angle(random));
        ASSERT_NEAR(geometry.toAxis(geometry.toMotor(rate)).degrees(), rate.degrees(), 1e-9);
    }
}
