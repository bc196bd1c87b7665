// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bus_name.h"

#include <QByteArray>
#include <QTcpServer>
#include <QTcpSocket>

#include <vector>

// A rotctld that the test controls. It answers each p with the text that the test has set, and keeps what it received.
namespace boresight::fakes {

class PlayingRotctld
{
public:
    PlayingRotctld()
    {
        m_server.listen(QHostAddress::LocalHost);
        QObject::connect(&m_server, &QTcpServer::newConnection, &m_server, [this] {
            QTcpSocket* const socket = m_server.nextPendingConnection();
            ++m_connections;
            m_sockets.push_back(socket);
            QObject::connect(socket, &QTcpSocket::readyRead, socket, [this, socket] {
                const QByteArray sent = socket->readAll();
                heard += sent;
                for (int i = 0; i < sent.count("p\n"); ++i) {
                    socket->write(answer);
                }
            });
        });
    }

    [[nodiscard]] BusName bus() const
    {
        return {.kind = BusKind::Rotctld, .target = "127.0.0.1", .port = m_server.serverPort()};
    }
    [[nodiscard]] QString name() const { return QStringLiteral("rotctld:127.0.0.1:%1").arg(m_server.serverPort()); }
    [[nodiscard]] int connections() const { return m_connections; }
    void dropAll()
    {
        for (QTcpSocket* const socket : m_sockets) {
            socket->abort();
        }
        m_sockets.clear();
    }
    // Accepts no more connections.
    void vanish()
    {
        m_server.close();
        dropAll();
    }

    QByteArray answer = "120.000000\n30.000000\n";  // empty: it stays silent
    QByteArray heard;

private:
    QTcpServer m_server;
    std::vector<QTcpSocket*> m_sockets;
    int m_connections = 0;
};

}  // namespace boresight::fakes
