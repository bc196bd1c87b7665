// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/beam.h"

#include <gtest/gtest.h>

namespace boresight::pointing {
namespace {

// REQ-POINTING-50 (Beam.*): The beam width is computed from dish and frequency, or from the gain. The loss by a
// pointing error is given in dB inside the main lobe, and is not guessed beyond it.
TEST(Beam, OfADish)
{
    EXPECT_NEAR(beamWidthOfDish(3.0, 1296e6).degrees(), 5.40, 0.01);  // λ = 0.2313 m
    EXPECT_NEAR(beamWidthOfDish(1.2, 10.368e9).degrees(), 1.69, 0.01);
    EXPECT_EQ(beamWidthOfDish(0.1, 145e6), 180_deg);
}

TEST(Beam, OfAGainAgreesWithTheDishOfThatGain)
{
    // 3 m at 1296 MHz with 55 % efficiency have 29.6 dBi.
    EXPECT_NEAR(beamWidthOfGain(29.6).degrees(), 5.34, 0.01);
    EXPECT_NEAR(beamWidthOfGain(12.0).degrees(), 40.5, 0.1);  // a Yagi of ten elements: 38° to 42°
    EXPECT_EQ(beamWidthOfGain(-3.0), 180_deg);
}

TEST(Beam, HalfABeamWidthOffIsHalfThePower)
{
    EXPECT_NEAR(pointingLoss(5_deg, 10_deg).value(), 3.0, 1e-12);
    EXPECT_NEAR(pointingLoss(1_deg, 10_deg).value(), 0.12, 1e-12);
    EXPECT_NEAR(pointingLoss(10_deg, 10_deg).value(), 12.0, 1e-12);
    EXPECT_FALSE(pointingLoss(10.1_deg, 10_deg).has_value());
}

}  // namespace
}  // namespace boresight::pointing
