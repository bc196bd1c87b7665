// SPDX-License-Identifier: GPL-3.0-or-later
// Loaded by LD_PRELOAD, this slows all time of a program and of its child programs by the factor kSlowness. If a
// computer runs nothing for 0.4 s, this is 0.08 s for them, less than the watchdog time of a drive. All of them have
// the same slow time, so a time written by one can be compared by another. User-Mode Linux also reads its clocks by
// clock_gettime(), and sleeps by POSIX timers that send a signal. Its main program calls these functions before
// libraries are ready, so they ask the kernel directly and use only syscall() of the C library. Waiting for an absolute
// time ends at once, and the times of files are not slowed: the programs of these tests use neither.
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

// For a signal timer the pointer contains the number that the kernel uses.
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
