// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/kept_clock.h"

#include "tests/fakes/manual_clock.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

class KeptClockTest : public ::testing::Test
{
protected:
    // By how much the clock is ahead of its start.
    [[nodiscard]] Seconds since() const { return kept.utc() - start; }

    fakes::ManualClock computer;
    KeptClock kept{computer};
    UtcTime start = computer.utc();
};

// REQ-STATION-233: The time that points the mount follows small corrections of the clock of this computer at once. When
// that clock is set by more than half a second, it continues as before until the new time is taken.
TEST_F(KeptClockTest, GoesOnWhenTheClockIsSet)
{
    computer.advance(Seconds(10.0));
    computer.stepUtc(Seconds(0.3));
    EXPECT_EQ(since(), Seconds(10.3));
    kept.follow();
    computer.stepUtc(Seconds(90.0));
    EXPECT_EQ(kept.ahead(), Seconds(90.0));
    EXPECT_EQ(since(), Seconds(10.3));
    computer.advance(Seconds(5.0));
    EXPECT_EQ(since(), Seconds(15.3));
    kept.follow();
    EXPECT_EQ(kept.ahead(), Seconds(0.0));
    EXPECT_EQ(since(), Seconds(105.3));
}

// REQ-STATION-233
TEST_F(KeptClockTest, AClockThatIsPutBackWasNeverAhead)
{
    computer.stepUtc(Seconds(-3600.0));
    computer.advance(Seconds(5.0));
    computer.stepUtc(Seconds(3600.0));
    EXPECT_EQ(kept.ahead(), Seconds(0.0));
    EXPECT_EQ(since(), Seconds(5.0));
}

// REQ-STATION-239: A time is confirmed by a time source that sets the clock with an error below half a second. While
// the clock is set, the old time is not confirmed.
TEST_F(KeptClockTest, ATimeSourceConfirmsWithASmallErrorOnly)
{
    EXPECT_TRUE(kept.isConfirmed());
    EXPECT_TRUE(kept.synchronised());
    computer.setError(Seconds(0.6));
    EXPECT_FALSE(kept.isConfirmed());
    computer.setError(Seconds(0.001));
    computer.setSynchronised(false);
    EXPECT_FALSE(kept.isConfirmed());
    computer.setSynchronised(true);
    computer.stepUtc(Seconds(90.0));
    EXPECT_TRUE(kept.isConfirmed()) << "the new time";
    EXPECT_FALSE(kept.synchronised()) << "the old time";
    EXPECT_EQ(kept.error(), std::nullopt);
}

// REQ-STATION-240: Log, alarms and files have the clock of this computer, also while the mount is pointed by the time
// before it was set.
TEST_F(KeptClockTest, TheClockOfTheComputerStaysKnown)
{
    computer.stepUtc(Seconds(-3600.0));
    computer.advance(Seconds(5.0));
    EXPECT_EQ(since(), Seconds(5.0));
    EXPECT_EQ(kept.computerUtc(), computer.utc());
}

// REQ-STATION-234: The time that this computer slept is no step of its clock.
TEST_F(KeptClockTest, SleepIsNoStep)
{
    computer.sleep(Seconds(20.0));
    EXPECT_EQ(kept.ahead(), Seconds(0.0));
    EXPECT_EQ(since(), Seconds(20.0));
}

}  // namespace
}  // namespace boresight
