// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/local_client.h"

#include "core/base/text.h"

#include <QFileInfo>
#include <QHostAddress>
#include <QThread>

namespace boresight::ctl {
namespace {

constexpr unsigned long kPause = 100;  // ms, between two attempts

bool isThisComputer(const std::string& host)
{
    return host == "localhost" || QHostAddress(toQString(host)).isLoopback();
}

QString socketOf(const profile::ListenAddress& station)
{
    return local::socketToAsk(local::runtimeFolder(), local::kServiceRuntimeFolder, station.port);
}

}  // namespace

bool hasLocalSocket(const profile::ListenAddress& station)
{
    return isThisComputer(station.host) && QFileInfo::exists(socketOf(station));
}

bool connectBy(const QDeadlineTimer& deadline, const std::function<QString()>& path, QLocalSocket& socket,
               const std::function<void()>& pause)
{
    for (;;) {
        socket.connectToServer(path());
        if (socket.waitForConnected(static_cast<int>(deadline.remainingTime()))) {
            return true;
        }
        if (deadline.hasExpired()) {
            return false;
        }
        pause();
    }
}

local::LocalAnswer askLocally(const profile::ListenAddress& station, const local::LocalRequest& request,
                              std::chrono::seconds patience)
{
    if (!isThisComputer(station.host)) {
        return failure(ErrorCode::InvalidInput,
                       QStringLiteral("this works only on the computer of the station, because it needs the local "
                                      "socket of the station, and \"%1\" is not localhost")
                           .arg(toQString(station.host)));
    }
    const auto path = [&station] { return socketOf(station); };
    if (path().isEmpty()) {
        return failure(ErrorCode::NoAnswer,
                       QStringLiteral("XDG_RUNTIME_DIR is not set, so there is no local socket of a station."));
    }
    QLocalSocket socket;
    if (!connectBy(QDeadlineTimer(kPatience), path, socket, [] { QThread::msleep(kPause); })) {
        return failure(ErrorCode::NoAnswer,
                       socket.error() == QLocalSocket::SocketAccessError
                           ? QStringLiteral("This user may not use %1. Try sudo.").arg(path())
                           : QStringLiteral("No station listens on %1. Start boresight or boresightd. If its rotctld "
                                            "port is not %2, use --station.")
                                 .arg(path())
                                 .arg(station.port));
    }
    socket.write(local::requestLine(request));
    // The whole patience again: the station may have obeyed already.
    const QDeadlineTimer deadline(patience);
    while (socket.state() == QLocalSocket::ConnectedState) {  // until the station has sent everything
        if (!socket.waitForReadyRead(static_cast<int>(deadline.remainingTime())) && deadline.hasExpired()) {
            return failure(ErrorCode::NoAnswer,
                           QStringLiteral("The station on %1 does not answer: %2.").arg(path(), socket.errorString()));
        }
    }
    return local::parseAnswer(socket.readAll());
}

}  // namespace boresight::ctl
