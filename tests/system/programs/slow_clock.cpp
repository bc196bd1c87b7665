// SPDX-License-Identifier: GPL-3.0-or-later
// Loaded into User-Mode Linux (LD_PRELOAD), this makes all time of the guest pass kSlowness times slower than the
// host's. Where a system call takes the guest twenty times longer than its host, the guest sees it take four times
// longer, and a host that runs nothing for half a second is 0.1 s in the guest. UML reads its clocks by clock_gettime()
// and sleeps by POSIX timers that send a signal; its own main program calls these functions before libraries are ready,
// so they ask the kernel themselves and use no library but the C library's syscall().
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <ctime>

namespace {

constexpr long kSlowness = 5;
constexpr long kSecond = 1'000'000'000;  // ns

long nanoseconds(const timespec& time)
{
    return time.tv_sec * kSecond + time.tv_nsec;
}

timespec timeOf(long nanoseconds)
{
    return {.tv_sec = nanoseconds / kSecond, .tv_nsec = nanoseconds % kSecond};
}

// A signal's timer is known to the kernel by the number that is in the pointer.
int kernelNumber(timer_t timer)
{
    return static_cast<int>(reinterpret_cast<long>(timer));
}

long beginnings[2] = {0, 0};  // of CLOCK_REALTIME and CLOCK_MONOTONIC, ns

}  // namespace

extern "C" int clock_gettime(clockid_t clock, timespec* time) noexcept
{
    const long status = syscall(SYS_clock_gettime, clock, time);
    if (status != 0 || (clock != CLOCK_REALTIME && clock != CLOCK_MONOTONIC)) {
        return static_cast<int>(status);
    }
    long& beginning = beginnings[clock];
    const long now = nanoseconds(*time);
    if (beginning == 0) {
        beginning = now;
    }
    *time = timeOf(beginning + (now - beginning) / kSlowness);
    return 0;
}

extern "C" int timer_settime(timer_t timer, int flags, const itimerspec* wanted, itimerspec* old) noexcept
{
    if (flags != 0) {
        errno = EINVAL;  // an absolute time, which UML does not use
        return -1;
    }
    const itimerspec slow{.it_interval = timeOf(nanoseconds(wanted->it_interval) * kSlowness),
                          .it_value = timeOf(nanoseconds(wanted->it_value) * kSlowness)};
    return static_cast<int>(syscall(SYS_timer_settime, kernelNumber(timer), 0, &slow, old));
}

extern "C" int timer_gettime(timer_t timer, itimerspec* left) noexcept
{
    const long status = syscall(SYS_timer_gettime, kernelNumber(timer), left);
    if (status == 0) {
        *left = {.it_interval = timeOf(nanoseconds(left->it_interval) / kSlowness),
                 .it_value = timeOf(nanoseconds(left->it_value) / kSlowness)};
    }
    return static_cast<int>(status);
}
