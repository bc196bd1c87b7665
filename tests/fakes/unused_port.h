// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QHostAddress>
#include <QTcpServer>
#include <QUdpSocket>

// A free port of this computer, or 0 if there is none. It is below the ports that Linux chooses itself (32768 to
// 60999), so no connection of another test takes it before it is used.
namespace boresight::fakes {

template <typename TakesPort>
[[nodiscard]] quint16 firstUnusedPort(TakesPort takes)
{
    constexpr int kFirst = 10000;
    constexpr int kEach = 64;  // ports of a process
    constexpr int kProcesses = 350;
    static int tried = 0;
    const int first = kFirst + static_cast<int>(QCoreApplication::applicationPid() % kProcesses) * kEach;
    for (int i = 0; i < kEach; ++i) {
        const auto port = static_cast<quint16>(first + tried++ % kEach);
        if (takes(port)) {
            return port;
        }
    }
    return 0;
}

[[nodiscard]] inline quint16 unusedPort()
{
    return firstUnusedPort([](quint16 port) { return QTcpServer().listen(QHostAddress::LocalHost, port); });
}

[[nodiscard]] inline quint16 unusedUdpPort()
{
    return firstUnusedPort([](quint16 port) {
        return QUdpSocket().bind(QHostAddress::LocalHost, port, QAbstractSocket::DontShareAddress);
    });
}

}  // namespace boresight::fakes
