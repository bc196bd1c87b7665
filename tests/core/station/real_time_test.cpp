// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/real_time.h"

#include <gtest/gtest.h>
#include <linux/capability.h>
#include <sched.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <ctime>
#include <thread>

namespace boresight {
namespace {

bool isReal()
{
    const int policy = sched_getscheduler(0) & ~SCHED_RESET_ON_FORK;
    return policy == SCHED_FIFO || policy == SCHED_RR;
}

// From here on this thread has the rights of an ordinary user, like the service. Root may change any scheduling.
void becomeOrdinary()
{
    __user_cap_header_struct header{.version = _LINUX_CAPABILITY_VERSION_3, .pid = 0};
    std::array<__user_cap_data_struct, 2> sets{};
    ASSERT_EQ(syscall(SYS_capget, &header, sets.data()), 0);
    sets[0].effective &= ~(1U << CAP_SYS_NICE);
    ASSERT_EQ(syscall(SYS_capset, &header, sets.data()), 0);
}

double cpuSeconds()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

// Whatever this computer allows, the report agrees with the kernel. A thread that never pauses must not block the
// computer.
// REQ-STATION-06b (RealTime.*, tests/bench/stalls): The thread of the control ticks asks for real-time scheduling. The
// status shows what the kernel granted. A thread that computes for 0.1 s without a pause gives it back.
TEST(RealTime, SaysWhatTheKernelDoes)
{
    std::thread([] {
        RealTime realTime;
        EXPECT_TRUE(realTime.text().isEmpty());
        realTime.ask();
        becomeOrdinary();
        EXPECT_EQ(realTime.isRealTime(), isReal());
        if (isReal()) {
            const double start = cpuSeconds();
            while (isReal() && cpuSeconds() - start < 3.0) {
            }
            EXPECT_FALSE(realTime.isRealTime()) << "after 0.1 s";
            EXPECT_TRUE(realTime.text().contains(QStringLiteral("gave it back")));
        } else {
            EXPECT_TRUE(realTime.text().contains(QStringLiteral("not allowed")));
        }
    }).join();
}

}  // namespace
}  // namespace boresight
