// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/format.h"

#include <gtest/gtest.h>

namespace boresight::ui {
namespace {

using std::chrono::milliseconds;

// REQ-UI-04 (Freshness.*): An old number is dimmed and shows its age after 0.5 s, and is not shown after 2 s, even if
// the station itself is silent.
TEST(Freshness, LiveLateNoData)
{
    EXPECT_EQ(freshness(std::nullopt), Freshness::NoData);
    EXPECT_EQ(freshness(milliseconds(499)), Freshness::Live);
    EXPECT_EQ(freshness(milliseconds(500)), Freshness::Late);
    EXPECT_EQ(freshness(milliseconds(1999)), Freshness::Late);
    EXPECT_EQ(freshness(milliseconds(2000)), Freshness::NoData);
}

TEST(Format, FixedDecimalsSignAndUnit)
{
    EXPECT_EQ(angleText(335.024_deg), QStringLiteral("335.02°"));
    EXPECT_EQ(angleText(-0.001_deg), QStringLiteral("0.00°"));
    EXPECT_EQ(signedAngleText(4.48_deg), QStringLiteral("+4.48°"));
    EXPECT_EQ(signedAngleText(-350_deg), QStringLiteral("-350.00°"));
    EXPECT_EQ(rateText(2_deg_s), QStringLiteral("2.0°/s"));
    EXPECT_EQ(directionText({-0.01_deg, 10_deg}), QStringLiteral("az 0.0°  el 10.0°"));
    EXPECT_EQ(directionText({473_deg, 10_deg}), QStringLiteral("az 113.0°  el 10.0°"));
    EXPECT_EQ(axisText({473_deg, 10_deg}), QStringLiteral("az 473.0°  el 10.0°"));
    EXPECT_EQ(ageText(milliseconds(1440)), QStringLiteral("1.4 s"));
}

TEST(Format, TimesAreUtcWithDateWhereItIsCopied)
{
    const UtcTime time = std::chrono::sys_days{std::chrono::year{2026} / 11 / 21} + std::chrono::hours(17) +
                         std::chrono::minutes(5) + milliseconds(59'120);
    EXPECT_EQ(clockText(time), QStringLiteral("17:05:59"));
    EXPECT_EQ(dateText(time), QStringLiteral("2026-11-21 17:05:59.120Z"));
}

}  // namespace
}  // namespace boresight::ui
