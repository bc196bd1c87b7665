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

// Above ordinary programs, below audio servers (20) and the threads of the kernel (50).
constexpr int kPriority = 10;
// The longest computing without a pause. After it the kernel sends SIGXCPU. rtkit permits at most 0.2 s.
constexpr rlim_t kLongestTurn = 100'000;    // µs
constexpr rlim_t kRtkitsLongest = 200'000;  // µs

std::atomic<pid_t> theThread{0};

// Ends real-time scheduling, so that an endless loop in the program does not block the computer. Uses only calls that
// are safe in a signal handler. SCHED_RESET_ON_FORK stays, because an ordinary user may not clear it.
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

// The answer arrives through the event loop. Nothing waits for it.
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
    limitTurns(kRtkitsLongest);  // rtkit refuses a program without this limit
    auto* const answer = new QDBusPendingCallWatcher(bus.asyncCall(call), this);
    connect(answer, &QDBusPendingCallWatcher::finished, this, [this, answer] {
        m_granted = !answer->isError();
        answer->deleteLater();
    });
}

// Locks memory only without a limit. With a limit, the program would get no more memory when the limit is reached.
void RealTime::lockMemory()
{
    raiseToHard(RLIMIT_MEMLOCK);
    m_locked =
        limitOf(RLIMIT_MEMLOCK).rlim_cur == RLIM_INFINITY && mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) == 0;
}

bool RealTime::isRealTime() const
{
    const int policy = sched_getscheduler(theThread) & ~SCHED_RESET_ON_FORK;
    return policy == SCHED_FIFO || policy == SCHED_RR;  // rtkit gives SCHED_RR
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
