// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/unix_signals.h"

#include <sys/socket.h>
#include <unistd.h>

#include <csignal>

namespace boresight::app {
namespace {

int writeEnd = -1;  // global, because a signal handler has no other way to reach it

void noteSignal(int number)
{
    const char byte = static_cast<char>(number);
    [[maybe_unused]] const auto written = ::write(writeEnd, &byte, 1);
}

void catchSignal(int number)
{
    struct sigaction action
    {};
    action.sa_handler = noteSignal;
    action.sa_flags = SA_RESTART;
    ::sigaction(number, &action, nullptr);
}

bool isIgnored(int number)
{
    struct sigaction action
    {};
    return ::sigaction(number, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

UnixSignals::UnixSignals(HangUp hangUp, QObject* parent) : QObject(parent), m_hangUp(hangUp)
{
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, m_sockets.data()) != 0) {
        return;  // the signals keep their default: the program dies and the drives stop by their watchdog
    }
    writeEnd = m_sockets[0];
    m_notifier = std::make_unique<QSocketNotifier>(m_sockets[1], QSocketNotifier::Read);
    connect(m_notifier.get(), &QSocketNotifier::activated, this, [this] {
        char byte = 0;
        if (::read(m_sockets[1], &byte, 1) == 1) {
            byte == SIGHUP&& m_hangUp == HangUp::Reloads ? Q_EMIT reloadRequested() : Q_EMIT endRequested();
        }
    });
    catchSignal(SIGTERM);
    catchSignal(SIGINT);
    if (m_hangUp == HangUp::Reloads || !isIgnored(SIGHUP)) {
        catchSignal(SIGHUP);
    }
}

UnixSignals::~UnixSignals()
{
    std::signal(SIGTERM, SIG_DFL);
    std::signal(SIGINT, SIG_DFL);
    if (!isIgnored(SIGHUP)) {
        std::signal(SIGHUP, SIG_DFL);
    }
    m_notifier.reset();
    for (const int socket : m_sockets) {
        if (socket >= 0) {
            ::close(socket);
        }
    }
}

}  // namespace boresight::app

#include "moc_unix_signals.cpp"
