// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service_notify.h"

#include <QByteArray>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstddef>
#include <cstring>

namespace boresight::app {

void notifyService(std::string_view state, bool wait)
{
    const QByteArray path = qgetenv("NOTIFY_SOCKET");
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (path.isEmpty() || static_cast<std::size_t>(path.size()) >= sizeof(address.sun_path)) {
        return;
    }
    std::memcpy(address.sun_path, path.constData(), static_cast<std::size_t>(path.size()));
    if (address.sun_path[0] == '@') {  // an abstract socket
        address.sun_path[0] = '\0';
    }
    const int socket = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    if (socket < 0) {
        return;
    }
    const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + static_cast<std::size_t>(path.size()));
    ::sendto(socket, state.data(), state.size(), MSG_NOSIGNAL | (wait ? 0 : MSG_DONTWAIT),
             reinterpret_cast<const sockaddr*>(&address), length);
    ::close(socket);
}

// As sd_watchdog_enabled(3). The check of the process id keeps a child of the service from feeding it.
ServiceWatchdog::ServiceWatchdog()
{
    const bool isOurs = qEnvironmentVariableIsEmpty("WATCHDOG_PID") ||
                        qgetenv("WATCHDOG_PID").toLongLong() == static_cast<qlonglong>(::getpid());
    const qlonglong granted = qgetenv("WATCHDOG_USEC").toLongLong();
    if (isOurs && granted > 0) {
        m_period = std::chrono::microseconds(granted / 2);
    }
}

void ServiceWatchdog::feed(SteadyTime now)
{
    if (m_period && (!m_fed || now - *m_fed >= *m_period)) {
        m_fed = now;
        notifyService("WATCHDOG=1", false);
    }
}

}  // namespace boresight::app
