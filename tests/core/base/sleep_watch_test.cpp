// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/sleep_watch.h"

#include "tests/fakes/manual_clock.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

// REQ-BASE-12: A sleep of the computer above 0.1 s is noticed once, with its length.
TEST(SleepWatch, NoticesEachSleepOnce)
{
    fakes::ManualClock clock;
    clock.sleep(Seconds(30.0));
    SleepWatch watch(clock);
    EXPECT_EQ(watch.sleptSince(clock), Seconds(0.0)) << "before it watched";
    clock.advance(Seconds(5.0));
    EXPECT_EQ(watch.sleptSince(clock), Seconds(0.0)) << "a stall is no sleep";
    clock.sleep(Seconds(0.05));
    EXPECT_EQ(watch.sleptSince(clock), Seconds(0.0));
    clock.sleep(Seconds(20.0));
    EXPECT_NEAR(watch.sleptSince(clock).count(), 20.05, 1e-6);
    EXPECT_EQ(watch.sleptSince(clock), Seconds(0.0));
}

}  // namespace
}  // namespace boresight
