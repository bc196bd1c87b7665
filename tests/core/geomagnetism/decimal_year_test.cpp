// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geomagnetism/decimal_year.h"

#include <gtest/gtest.h>

using namespace boresight;

TEST(DecimalYear, CountsTheDaysOfEachYear)
{
    using geomagnetism::decimalYear;
    using namespace std::chrono;
    EXPECT_DOUBLE_EQ(decimalYear(sys_days(year(2026) / 1 / 1)), 2026.0);
    EXPECT_DOUBLE_EQ(decimalYear(sys_days(year(2026) / 7 / 2) + hours(12)), 2026.5);
    EXPECT_DOUBLE_EQ(decimalYear(sys_days(year(2028) / 7 / 2)), 2028.5) << "a leap year";
    EXPECT_NEAR(decimalYear(sys_days(year(2029) / 12 / 31) + hours(24) - seconds(1)), 2030.0, 1e-7);
    EXPECT_LT(decimalYear(sys_days(year(2029) / 12 / 31) + hours(24) - seconds(1)), 2030.0);
}
