// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/can_frame.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

// REQ-BASE-03 (CanFrame.*): Two CAN frames are equal if they are the same on the wire. Lengths are those of CAN-FD.
TEST(CanFrame, LegalLengthIsTheSmallestThatHolds)
{
    EXPECT_EQ(legalCanLength(0), 0U);
    EXPECT_EQ(legalCanLength(8), 8U);
    EXPECT_EQ(legalCanLength(9), 12U);
    EXPECT_EQ(legalCanLength(12), 12U);
    EXPECT_EQ(legalCanLength(25), 32U);
    EXPECT_EQ(legalCanLength(33), 48U);
    EXPECT_EQ(legalCanLength(49), 64U);
    EXPECT_EQ(legalCanLength(64), 64U);
}

TEST(CanFrame, EqualityIgnoresArrivalTimeAndUnusedBytes)
{
    CanFrame a;
    a.id = 0x8001;
    a.setPayload(std::array<std::uint8_t, 2>{1, 2});
    CanFrame b = a;
    b.received += std::chrono::seconds(1);
    b.data[5] = 7;
    EXPECT_EQ(a, b);
    b.data[1] = 3;
    EXPECT_FALSE(a == b);
    b = a;
    b.bitRateSwitch = false;
    EXPECT_FALSE(a == b);
}

TEST(CanFrame, PrintsIdLengthAndBytes)
{
    CanFrame frame;
    frame.id = 0x8001;
    frame.setPayload(std::array<std::uint8_t, 3>{0x11, 0x00, 0x0f});
    EXPECT_EQ(toString(frame), "8001 [3] 11 00 0f");
}

}  // namespace
}  // namespace boresight
