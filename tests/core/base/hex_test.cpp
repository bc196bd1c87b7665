// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/hex.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

// REQ-BASE-02 (Hex.*): An even number of hex digits is read as bytes. Anything else is refused.
TEST(Hex, BytesToTextAndBack)
{
    const std::vector<std::uint8_t> bytes{0x00, 0x0f, 0xa5, 0xff};
    EXPECT_EQ(toHex(bytes), "000fa5ff");
    EXPECT_EQ(toHex(bytes, HexCase::Upper), "000FA5FF");
    EXPECT_EQ(parseHex("000fA5Ff"), bytes);
    EXPECT_EQ(parseHex(""), std::vector<std::uint8_t>{});
}

TEST(Hex, AnythingElseIsNotHex)
{
    for (const char* const bad : {"0", "0g", "0x10", " 00", "00 ", "+1", "-1", "0\xc3"}) {
        EXPECT_EQ(parseHex(bad), std::nullopt) << bad;
    }
}

}  // namespace
}  // namespace boresight
