// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/system/programs/starved_time.h"

#include <pthread.h>
#include <sched.h>

namespace boresight::system_test {

using std::chrono::duration_cast;
using std::chrono::milliseconds;

StarvedTime::StarvedTime() : m_thread([this] { watch(); })
{
    sched_param highest{};
    highest.sched_priority = sched_get_priority_max(SCHED_FIFO);
    static_cast<void>(pthread_setschedparam(m_thread.native_handle(), SCHED_FIFO, &highest));
}

StarvedTime::~StarvedTime()
{
    m_ends = true;
    m_thread.join();
}

void StarvedTime::watch()
{
    constexpr milliseconds kPause(5);
    constexpr milliseconds kUsual(20);  // the guest's own clock ticks every 10 ms
    auto last = std::chrono::steady_clock::now();
    while (!m_ends) {
        std::this_thread::sleep_for(kPause);
        const auto now = std::chrono::steady_clock::now();
        if (now - last > kUsual) {
            m_total = m_total.load() + duration_cast<milliseconds>(now - last - kPause);
        }
        last = now;
    }
}

}  // namespace boresight::system_test
