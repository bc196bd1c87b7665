// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/clock.h"

#include <gtest/gtest.h>
#include <sys/timex.h>

namespace boresight {
namespace {

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

}  // namespace
}  // namespace boresight
