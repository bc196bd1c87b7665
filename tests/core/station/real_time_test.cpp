// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/real_time.h"

#include <gtest/gtest.h>
#include <sched.h>

#include <ctime>
#include <thread>

namespace boresight {
namespace {

int policy()
{
    return sched_getscheduler(0) & ~SCHED_RESET_ON_FORK;
}

double cpuSeconds()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

// Whatever this machine allows, what is said is what is so; and a thread that never pauses gives the computer back.
TEST(RealTime, SaysWhatTheKernelDoes)
{
    std::thread([] {
        RealTime realTime;
        EXPECT_TRUE(realTime.text().isEmpty());
        realTime.ask();
        EXPECT_EQ(realTime.isRealTime(), policy() == SCHED_FIFO);
        EXPECT_EQ(realTime.text().contains(QStringLiteral("on.")), policy() == SCHED_FIFO);
        if (realTime.isRealTime()) {
            const double start = cpuSeconds();
            while (policy() == SCHED_FIFO && cpuSeconds() - start < 3.0) {
            }
            EXPECT_FALSE(realTime.isRealTime()) << "after 0.1 s";
            EXPECT_TRUE(realTime.text().contains(QStringLiteral("given back")));
        } else {
            EXPECT_TRUE(realTime.text().contains(QStringLiteral("not allowed")));
        }
    }).join();
}

}  // namespace
}  // namespace boresight
