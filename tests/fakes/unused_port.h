// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHostAddress>
#include <QTcpServer>
#include <QUdpSocket>

// A free port of this computer, or 0 if there is none.
namespace boresight::fakes {

[[nodiscard]] inline quint16 unusedPort()
{
    QTcpServer server;
    return server.listen(QHostAddress::LocalHost) ? server.serverPort() : quint16{0};
}

[[nodiscard]] inline quint16 unusedUdpPort()
{
    QUdpSocket udp;
    return udp.bind(QHostAddress::LocalHost, 0) ? udp.localPort() : quint16{0};
}

}  // namespace boresight::fakes
