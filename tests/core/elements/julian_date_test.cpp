// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/julian_date.h"

#include "core/elements/iso_epoch.h"
#include "core/elements/written_time.h"

#include <gtest/gtest.h>

using namespace boresight;
using namespace boresight::orbit;

namespace {

constexpr std::chrono::sys_days kPublishedDay{std::chrono::year{2024} / 5 / 9};

}  // namespace

// REQ-ORBIT-04: Times are exact to the microsecond, because a Julian date has two parts.
TEST(JulianDates, KeepTheMicrosecond)
{
    const UtcTime time = kPublishedDay + std::chrono::hours(8) + std::chrono::microseconds(2'899'938'816);
    EXPECT_EQ(julianDate(time).day, 2460439.5);
    EXPECT_EQ(utcTime(julianDate(time)), time);
    EXPECT_EQ(utcTime(julianDate(2024, 129.0)), UtcTime(kPublishedDay));
    EXPECT_NEAR(minutesBetween(julianDate(kPublishedDay), julianDate(time)) * 60e6, 31'699'938'816.0, 0.01);
}

TEST(JulianDates, ThoseThatTheClockCannotHoldAreItsEnds)
{
    EXPECT_LT(utcTime({1e300, 0.0}), UtcTime::max());
    EXPECT_GT(utcTime({-1e300, 0.0}), UtcTime::min());
}

// REQ-ORBIT-04
TEST(IsoEpoch, ReadsBothFormsOfTheDate)
{
    const auto epoch = parseIsoEpoch("2024-05-09T08:48:19.938816");
    ASSERT_TRUE(epoch);
    EXPECT_EQ(utcTime(*epoch), UtcTime(kPublishedDay + std::chrono::microseconds(31'699'938'816)));
    EXPECT_EQ(parseIsoEpoch("2024-130T08:48:19.938816Z"), epoch);
    EXPECT_EQ(parseIsoEpoch("2024-05-09 08:48:19.938816"), epoch);
    EXPECT_TRUE(parseIsoEpoch("2016-12-31T23:59:60"));
    EXPECT_TRUE(parseIsoEpoch("2024-366T00:00:00"));
}

// REQ-ORBIT-04
TEST(IsoEpoch, RefusesWhatIsNoTime)
{
    for (const char* const wrong :
         {"", "2024", "2024-05-09", "2024-13-01T00:00:00", "2023-02-29T00:00:00", "2023-366T00:00:00",
          "2024-000T00:00:00", "2024-05-09T24:00:00", "2024-05-09T00:60:00", "2024-05-09T00:00:61",
          "2024-05-09T00:00:", "2024-05-09T00:00", "2024-05-09T00:00:1e1", "1956-05-09T00:00:00", "9999-05-09T00:00:00",
          "2024/05/09T00:00:00", "-024-05-09T00:00:00", "2024-05-09T00:00:nan"}) {
        EXPECT_FALSE(parseIsoEpoch(wrong)) << wrong;
    }
}

// REQ-ORBIT-40: Times in lists have the forms of CCSDS, and also without seconds, as a day alone, with +00:00, or as
// Unix seconds. A leap second is later than the second before it.
TEST(WrittenTime, IsReadAsPeopleWriteIt)
{
    const auto utcOf = [](const char* text) { return utcTime(parseWrittenTime(text).value_or(JulianDate())); };
    const UtcTime moment = kPublishedDay + std::chrono::hours(8) + std::chrono::minutes(48);
    for (const char* const text : {"2024-05-09T08:48:00Z", "2024-05-09T08:48", "2024-05-09 08:48:00+00:00",
                                   "2024-130T08:48Z", "1715244480", "1715244480.0"}) {
        EXPECT_EQ(utcOf(text), moment) << text;
    }
    EXPECT_EQ(utcOf("2024-05-09"), UtcTime(kPublishedDay));
    const auto leap = parseWrittenTime("2016-12-31T23:59:60.5").value_or(JulianDate());
    EXPECT_NEAR(leap.fraction * 86400.0, 86400.5, 1e-6);
    for (const char* const wrong : {"", "Z", "now", "2024", "20240510", "2024-05-09T08:48:00+01:00", "nan", "1e30"}) {
        EXPECT_FALSE(parseWrittenTime(wrong)) << wrong;
    }
}
