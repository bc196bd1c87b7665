// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/real_time.h"

#include "core/base/text.h"

#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusPendingCallWatcher>

#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>

namespace boresight {
namespace {

// Above ordinary programs, below the kernel's own threads (50) and audio servers (20).
constexpr int kPriority = 10;
// Without a pause; rtkit allows 0.2 s at most. The kernel sends SIGXCPU then.
constexpr rlim_t kLongestTurn = 100'000;    // µs
constexpr rlim_t kRtkitsLongest = 200'000;  // µs

std::atomic<pid_t> theThread{0};

// A program that runs wild must not take the computer with it. Only calls that are safe in a signal handler. An
// ordinary user may not take SCHED_RESET_ON_FORK back.
void giveBack(int)
{
    const sched_param ordinary{};
    (void)sched_setscheduler(theThread.load(), SCHED_OTHER | SCHED_RESET_ON_FORK, &ordinary);
}

rlimit limitOf(int resource)
{
    rlimit limit{};
    (void)getrlimit(static_cast<__rlimit_resource>(resource), &limit);
    return limit;
}

void setLimit(int resource, const rlimit& limit)
{
    (void)setrlimit(static_cast<__rlimit_resource>(resource), &limit);
}

void raiseToHard(int resource)
{
    rlimit limit = limitOf(resource);
    limit.rlim_cur = limit.rlim_max;
    setLimit(resource, limit);
}

void limitTurns(rlim_t longest)
{
    struct sigaction action
    {};
    action.sa_handler = giveBack;
    action.sa_flags = SA_RESTART;
    (void)sigaction(SIGXCPU, &action, nullptr);
    rlimit limit = limitOf(RLIMIT_RTTIME);
    limit.rlim_max = std::min(limit.rlim_max, longest);
    limit.rlim_cur = std::min(limit.rlim_max, kLongestTurn);
    setLimit(RLIMIT_RTTIME, limit);
}

}  // namespace

void RealTime::ask()
{
    m_asked = true;
    theThread = gettid();
    raiseToHard(RLIMIT_RTPRIO);
    askKernel();
    if (!m_granted) {
        askRtkit();
    }
    lockMemory();
}

void RealTime::askKernel()
{
    const sched_param wanted{.sched_priority = kPriority};
    m_granted = sched_setscheduler(0, SCHED_FIFO | SCHED_RESET_ON_FORK, &wanted) == 0;
    if (m_granted) {
        limitTurns(RLIM_INFINITY);
    }
}

// Answers through the event loop: nobody waits for it.
void RealTime::askRtkit()
{
    QDBusMessage call = QDBusMessage::createMethodCall(
        QStringLiteral("org.freedesktop.RealtimeKit1"), QStringLiteral("/org/freedesktop/RealtimeKit1"),
        QStringLiteral("org.freedesktop.RealtimeKit1"), QStringLiteral("MakeThreadRealtime"));
    call << static_cast<qulonglong>(gettid()) << static_cast<uint>(kPriority);
    const QDBusConnection bus = QDBusConnection::systemBus();
    if (!bus.isConnected()) {
        return;
    }
    limitTurns(kRtkitsLongest);  // it refuses a program without this limit
    auto* const answer = new QDBusPendingCallWatcher(bus.asyncCall(call), this);
    connect(answer, &QDBusPendingCallWatcher::finished, this, [this, answer] {
        m_granted = !answer->isError();
        answer->deleteLater();
    });
}

// Only where there is no limit: with one, memory could not be had any more when it is reached.
void RealTime::lockMemory()
{
    raiseToHard(RLIMIT_MEMLOCK);
    m_locked =
        limitOf(RLIMIT_MEMLOCK).rlim_cur == RLIM_INFINITY && mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) == 0;
}

bool RealTime::isRealTime() const
{
    const int policy = sched_getscheduler(theThread) & ~SCHED_RESET_ON_FORK;
    return policy == SCHED_FIFO || policy == SCHED_RR;  // rtkit gives the second
}

QString RealTime::text() const
{
    if (!m_asked) {
        return {};
    }
    if (!m_granted) {
        return Text::tr("Real-time scheduling: not allowed. Install rtkit or raise the limit RLIMIT_RTPRIO.");
    }
    if (!isRealTime()) {
        return Text::tr("Real-time scheduling: off. Boresight gave it back after 0.1 s of work without a pause.");
    }
    return m_locked ? Text::tr("Real-time scheduling: on. Memory: locked in RAM.")
                    : Text::tr("Real-time scheduling: on. Memory: not locked (limit RLIMIT_MEMLOCK).");
}

}  // namespace boresight

#include "moc_real_time.cpp"
