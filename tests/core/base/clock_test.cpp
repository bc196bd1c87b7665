// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/clock.h"

#include <gtest/gtest.h>
#include <sys/timex.h>

#include <ctime>

namespace boresight {
namespace {

std::chrono::nanoseconds bootTime()
{
    timespec time{};
    EXPECT_EQ(::clock_gettime(CLOCK_BOOTTIME, &time), 0);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

// REQ-BASE-11: The steady time continues while the computer sleeps.
TEST(Clock, GoesOnWhileTheComputerSleeps)
{
    const std::chrono::nanoseconds before = bootTime();
    const std::chrono::nanoseconds now = SystemClock().now().time_since_epoch();
    const std::chrono::nanoseconds after = bootTime();
    EXPECT_LE(before, now);
    EXPECT_LE(now, after);
}

// REQ-CONTROL-39a (Clock.*)
// REQ-BASE-09 (Clock.*): Whether the kernel's clock is synchronised is read from the kernel.
TEST(Clock, IsSynchronisedWhenTheKernelSaysSo)
{
    EXPECT_TRUE(isSynchronised(TIME_OK, 0));
    EXPECT_TRUE(isSynchronised(TIME_OK, STA_PLL | STA_NANO));
    EXPECT_TRUE(isSynchronised(TIME_INS, STA_PLL)) << "a leap second is announced";
    EXPECT_FALSE(isSynchronised(TIME_ERROR, STA_UNSYNC)) << "after the start of a computer";
    EXPECT_FALSE(isSynchronised(TIME_ERROR, STA_PLL));
    EXPECT_FALSE(isSynchronised(TIME_OK, STA_UNSYNC));
    EXPECT_FALSE(isSynchronised(-1, 0)) << "a sandbox forbids to ask";
}

// REQ-BASE-10: The error of a clock is the correction that its time source still has to make plus the error that the
// source estimates. The kernel reports the correction in nanoseconds or microseconds.
TEST(Clock, HasTheErrorThatTheTimeSourceReports)
{
    EXPECT_DOUBLE_EQ(reportedError(-2'000'000, 500, STA_PLL | STA_NANO).count(), 0.0025);
    EXPECT_DOUBLE_EQ(reportedError(2'000, 500, STA_PLL).count(), 0.0025);
}

}  // namespace
}  // namespace boresight
