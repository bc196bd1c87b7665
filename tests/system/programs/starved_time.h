// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <thread>

namespace boresight::system_test {

// The time in which this computer ran nothing at all. A guest of User-Mode Linux has one processor, which its host may
// give to others for half a second. A thread with the highest priority reads the clock every 5 ms, and gaps are the
// time that was not run. Without the right to such a thread, the time in which other programs ran counts too.
class StarvedTime
{
public:
    StarvedTime();
    ~StarvedTime();
    StarvedTime(const StarvedTime&) = delete;
    StarvedTime& operator=(const StarvedTime&) = delete;

    // Since the start. May be called from any thread.
    [[nodiscard]] std::chrono::milliseconds total() const { return m_total.load(); }

private:
    void watch();

    std::atomic<std::chrono::milliseconds> m_total{std::chrono::milliseconds(0)};
    std::atomic<bool> m_ends = false;
    std::thread m_thread;
};

}  // namespace boresight::system_test
