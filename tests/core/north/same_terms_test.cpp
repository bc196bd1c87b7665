// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/same_terms.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

using namespace boresight::literals;

TEST(SameTerms, OnlyRoundingIsNoDifference)
{
    pointing::PointingTerms a{.azimuthOffset = 37.4_deg, .tiltNorth = 0.5_deg};
    pointing::PointingTerms b = a;
    b.tiltNorth += Angle::fromDegrees(1e-9);
    EXPECT_TRUE(isSame(a, b));
    b.tiltNorth += Angle::fromDegrees(2e-9);
    EXPECT_FALSE(isSame(a, b));
    EXPECT_TRUE(isSame(a, b, 0.001_deg)) << "within the tolerance that is asked for";
}

TEST(SameTerms, AMountingIsTheSameAfterAFullTurn)
{
    calibration::SensorMounting a{.azimuthOffset = -170_deg};
    calibration::SensorMounting b{.azimuthOffset = 190_deg};
    EXPECT_TRUE(isSame(a, b));
    b.elevationOffset = 0.01_deg;
    EXPECT_FALSE(isSame(a, b));
}

TEST(SameTerms, NoCurveIsTheSameAsAFlatOne)
{
    calibration::SensorMounting a;
    calibration::SensorMounting b{.curve = calibration::DeviationCurve{}};
    EXPECT_TRUE(isSame(a, b));
    b.curve->b1 = 1_deg;
    EXPECT_FALSE(isSame(a, b));
}

TEST(SameTerms, AnArcIsTheSameWithinTheLastPlaceOfAProfile)
{
    calibration::SensorMounting a{.curve = calibration::DeviationCurve{}};
    a.curve->unreliable = {{.from = 10_deg, .to = 20_deg}};
    calibration::SensorMounting b = a;
    b.curve->unreliable.front().to = 20.05_deg;
    EXPECT_TRUE(isSame(a, b));
    b.curve->unreliable.front().to = 20.1_deg;
    EXPECT_FALSE(isSame(a, b));
    b.curve->unreliable.clear();
    EXPECT_FALSE(isSame(a, b));
}

TEST(SameTerms, WhoTypesOneTermChangesOne)
{
    const pointing::PointingTerms present{.azimuthOffset = Angle::fromDegrees(37.4000000012), .tiltNorth = 0.5_deg};
    const pointing::PointingTerms typed{.azimuthOffset = 37.4_deg, .tiltNorth = 0.6_deg};
    const pointing::PointingTerms changed = changedOnly(typed, present);
    EXPECT_EQ(present.azimuthOffset, changed.azimuthOffset);
    EXPECT_EQ(0.6_deg, changed.tiltNorth);
}

}  // namespace
}  // namespace boresight
