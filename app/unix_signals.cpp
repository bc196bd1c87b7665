// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/unix_signals.h"

#include <sys/socket.h>
#include <unistd.h>

#include <csignal>

namespace boresight::app {
namespace {

int writeEnd = -1;  // a signal handler can reach nothing but globals

void noteSignal(int)
{
    const char byte = 1;
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

}  // namespace

UnixSignals::UnixSignals(QObject* parent) : QObject(parent)
{
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, m_sockets.data()) != 0) {
        return;  // the signals then keep their default: the program dies and the drives stop by their watchdog
    }
    writeEnd = m_sockets[0];
    m_notifier = std::make_unique<QSocketNotifier>(m_sockets[1], QSocketNotifier::Read);
    connect(m_notifier.get(), &QSocketNotifier::activated, this, [this] {
        char byte = 0;
        if (::read(m_sockets[1], &byte, 1) == 1) {
            Q_EMIT endRequested();
        }
    });
    catchSignal(SIGTERM);
    catchSignal(SIGINT);
}

UnixSignals::~UnixSignals()
{
    std::signal(SIGTERM, SIG_DFL);
    std::signal(SIGINT, SIG_DFL);
    m_notifier.reset();
    for (const int socket : m_sockets) {
        if (socket >= 0) {
            ::close(socket);
        }
    }
}

}  // namespace boresight::app
