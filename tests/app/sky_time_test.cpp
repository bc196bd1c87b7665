// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/sky_time.h"

#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>

#include <chrono>

namespace boresight::ctl {
namespace {

using namespace std::chrono_literals;

const UtcTime kMoment = std::chrono::sys_days(std::chrono::year(2024) / 5 / 10) + 4h + 50min + 2s;

// REQ-CTL-01: Times are UTC in ISO forms, or Unix seconds. A text that is not a time is refused, and never read as
// another time.
TEST(SkyTime, IsReadInEachForm)
{
    for (const char* const text : {"2024-05-10T04:50:02Z", "2024-05-10T04:50:02", "2024-05-10 04:50:02.000Z",
                                   "2024-05-10T04:50:02+00:00", "2024-131T04:50:02Z", "1715316602", "1715316602.0"}) {
        EXPECT_EQ(parseSkyTime(text).value_or(UtcTime()), kMoment) << text;
    }
    EXPECT_EQ(parseSkyTime("2024-05-10T04:50Z").value_or(UtcTime()), kMoment - 2s);
    EXPECT_EQ(parseSkyTime("2024-05-10").value_or(UtcTime()), kMoment - 4h - 50min - 2s);
    EXPECT_EQ(parseSkyTime("2024-05-10T04:50:02.125Z").value_or(UtcTime()), kMoment + 125ms);
}

// REQ-CTL-01
TEST(SkyTime, RefusesWhatIsNoTime)
{
    for (const char* const text : {"", "Z", "now", "T04:50:02", "04:50:02", "2024", "20240510", "2024-13-01",
                                   "2024-05-10T04:50:02+01:00", "2024-05-10T25:00:00Z", "-1715316602", "nan", "1e30"}) {
        EXPECT_FALSE(parseSkyTime(text)) << text;
    }
    EXPECT_EQ(textOf(parseSkyTime("10.5.2024").error()),
              "\"10.5.2024\" is not a time: expected UTC like 2024-05-10T04:50:02Z, or Unix seconds");
}

TEST(SkyTime, IsWrittenWithTheDigitsThatItTakes)
{
    EXPECT_EQ(skyTimeText(kMoment, 0), "2024-05-10T04:50:02Z");
    EXPECT_EQ(skyTimeText(kMoment, 3), "2024-05-10T04:50:02.000Z");
    EXPECT_EQ(skyTimeText(kMoment + 50ms, 0), "2024-05-10T04:50:02.05Z");
    EXPECT_EQ(skyTimeText(kMoment + 1us, 3), "2024-05-10T04:50:02.000001Z");
    EXPECT_EQ(skyTimeText(kMoment + 999'999'900ns, 0), "2024-05-10T04:50:03Z");
}

}  // namespace
}  // namespace boresight::ctl
