// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/paced_outlet.h"

#include "tests/fakes/wait_until.h"

#include <QElapsedTimer>

#include <gtest/gtest.h>

namespace boresight {
namespace {

struct PacedOutletTest : testing::Test
{
    [[nodiscard]] bool sends(int count)
    {
        return fakes::waitUntil([this, count] { return sent >= count; });
    }
    // Waits longer than the pause between two reports.
    static void letThePauseEnd()
    {
        bool isOver = false;
        QTimer::singleShot(2 * PacedOutlet::kPeriod, [&isOver] { isOver = true; });
        ASSERT_TRUE(fakes::waitUntil([&isOver] { return isOver; }));
    }

    QObject owner;
    int sent = 0;
    PacedOutlet outlet{&owner, [this] { ++sent; }};
};

// REQ-MQTT-09c (PacedOutletTest.*)
// REQ-POWER-08 (PacedOutletTest.*)
// REQ-BASE-05 (PacedOutletTest.*): From one thread to another at most one report is sent every 20 ms, and none before
// the last one was taken.
TEST_F(PacedOutletTest, TheFirstReportGoesOutAtOnceAndTheNextAfterThePause)
{
    QElapsedTimer time;
    time.start();
    outlet.ask();
    EXPECT_EQ(sent, 1);
    outlet.taken();
    for (int i = 0; i < 1000; ++i) {
        outlet.ask();
    }
    EXPECT_EQ(sent, 1);
    ASSERT_TRUE(sends(2));
    EXPECT_GE(time.elapsed(), PacedOutlet::kPeriod.count() - 1);
    outlet.taken();
    letThePauseEnd();
    EXPECT_EQ(sent, 2) << "nothing more was asked for";
}

TEST_F(PacedOutletTest, NoReportGoesOutBeforeTheLastOneWasTaken)
{
    outlet.ask();
    outlet.ask();
    letThePauseEnd();
    EXPECT_EQ(sent, 1);
    outlet.taken();
    EXPECT_EQ(sent, 2);
}

}  // namespace
}  // namespace boresight
