// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHostAddress>
#include <QTcpServer>

// A port of this computer that nobody has now.
namespace boresight::fakes {

[[nodiscard]] inline quint16 unusedPort()
{
    QTcpServer server;
    return server.listen(QHostAddress::LocalHost) ? server.serverPort() : quint16{0};
}

}  // namespace boresight::fakes
