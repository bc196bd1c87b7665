// SPDX-License-Identifier: GPL-3.0-or-later
// Loaded by LD_PRELOAD, this makes all time of a program, and of those that it starts, pass kSlowness times slower than
// the computer's. A computer that runs nothing for 0.4 s is 0.08 s to them, less than the watchdog of a drive. It is
// one slow time for all of them: what one wrote, another one can compare with its own clock. User-Mode Linux reads its
// clocks by clock_gettime(), too, and sleeps by POSIX timers that send a signal. Its own main program calls these
// functions before libraries are ready, so they ask the kernel themselves and use no library but the C library's
// syscall().
// Waits until an absolute time end at once, and the times of files are not slowed: no program of these tests uses
// either.
#include <sys/syscall.h>
#include <sys/time.h>
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

long sinceTheBoot()  // ns
{
    timespec time{};
    syscall(SYS_clock_gettime, CLOCK_MONOTONIC, &time);
    return nanoseconds(time);
}

}  // namespace

extern "C" int clock_gettime(clockid_t clock, timespec* time) noexcept
{
    const long status = syscall(SYS_clock_gettime, clock, time);
    const bool isSlowed = clock == CLOCK_REALTIME || clock == CLOCK_MONOTONIC || clock == CLOCK_BOOTTIME;
    if (status != 0 || !isSlowed) {
        return static_cast<int>(status);
    }
    const long passed = sinceTheBoot();
    *time = timeOf(nanoseconds(*time) - passed + passed / kSlowness);
    return 0;
}

extern "C" int gettimeofday(timeval* time, void*) noexcept
{
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    *time = {.tv_sec = now.tv_sec, .tv_usec = now.tv_nsec / 1000};
    return 0;
}

extern "C" time_t time(time_t* into) noexcept
{
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    if (into != nullptr) {
        *into = now.tv_sec;
    }
    return now.tv_sec;
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
