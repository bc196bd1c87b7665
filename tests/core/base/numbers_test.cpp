// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/numbers.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

// REQ-BASE-01 (Numbers.*): A text is a number only if the whole text is one, whatever the locale. No text is `-0.00`.
TEST(Numbers, WholeFiniteTextOnly)
{
    EXPECT_EQ(parseFinite("10.5"), 10.5);
    EXPECT_EQ(parseFinite("+10"), 10.0);
    EXPECT_EQ(parseFinite("-1e-05"), -1e-05);
    for (const char* const bad :
         {"", "nan", "inf", "-inf", "1e400", "10deg", " 1", "1 ", "+-1", "--1", "0x10", "1,5"}) {
        EXPECT_EQ(parseFinite(bad), std::nullopt) << bad;
    }
}

TEST(Numbers, Integers)
{
    EXPECT_EQ(parseInteger("42"), 42);
    EXPECT_EQ(parseInteger("-7"), -7);
    EXPECT_EQ(parseInteger("8001", 16), 0x8001);
    EXPECT_EQ(parseInteger("1.5"), std::nullopt);
    EXPECT_EQ(parseInteger("99999999999999999999"), std::nullopt);
}

TEST(Numbers, FixedDecimalsWithoutNegativeZero)
{
    EXPECT_EQ(formatFixed(12.345678, 2), "12.35");
    EXPECT_EQ(formatFixed(-0.001, 2), "0.00");
    EXPECT_EQ(formatFixed(-0.006, 2), "-0.01");
    EXPECT_EQ(formatFixed(5, 6), "5.000000");
}

}  // namespace
}  // namespace boresight
