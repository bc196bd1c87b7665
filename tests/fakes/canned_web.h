// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>
#include <QTcpServer>
#include <QTcpSocket>

#include <map>
#include <string>
#include <vector>

// A web server on 127.0.0.1. For each path it sends the bytes that the test has set, headers included. Then it closes
// the connection, sends without end, or stays silent. It keeps the requests. It runs on the thread of the event loop.
namespace boresight::fakes {

class CannedWeb
{
public:
    enum class Then
    {
        Closes,
        GoesOn,  // sends spaces without end
        Waits
    };

    CannedWeb()
    {
        m_server.listen(QHostAddress::LocalHost);
        m_port = m_server.serverPort();
        QObject::connect(&m_server, &QTcpServer::newConnection, &m_server, [this] { serve(); });
    }

    [[nodiscard]] std::string address(const std::string& path) const
    {
        return "http://127.0.0.1:" + std::to_string(m_port) + path;
    }
    void answers(const std::string& path, QByteArray bytes, Then then = Then::Closes)
    {
        m_answers[path] = {std::move(bytes), then};
    }
    void answersWith(const std::string& path, const QByteArray& status, const QByteArray& headers,
                     const QByteArray& content)
    {
        answers(path, "HTTP/1.1 " + status + "\r\nConnection: close\r\nContent-Length: " +
                          QByteArray::number(content.size()) + "\r\n" + headers + "\r\n" + content);
    }
    void stopListening() { m_server.close(); }
    // The headers of the requests, in order.
    [[nodiscard]] const std::vector<std::string>& questions() const { return m_questions; }

private:
    struct Answer
    {
        QByteArray bytes;
        Then then = Then::Closes;
    };

    void serve()
    {
        while (QTcpSocket* const peer = m_server.nextPendingConnection()) {
            QObject::connect(peer, &QTcpSocket::disconnected, peer, &QObject::deleteLater);
            QObject::connect(peer, &QTcpSocket::readyRead, peer, [this, peer] {
                const QByteArray head = peer->peek(peer->bytesAvailable());
                if (head.contains("\r\n\r\n")) {
                    answer(*peer, peer->readAll());
                }
            });
        }
    }

    void answer(QTcpSocket& peer, const QByteArray& head)
    {
        QObject::disconnect(&peer, &QTcpSocket::readyRead, nullptr, nullptr);  // one reply for each connection
        m_questions.push_back(head.toStdString());
        const Answer& given = m_answers[head.split(' ').value(1).toStdString()];
        peer.write(given.bytes);
        if (given.then == Then::Closes) {
            peer.disconnectFromHost();
        } else if (given.then == Then::GoesOn) {
            QObject::connect(&peer, &QTcpSocket::bytesWritten, &peer, [&peer] {
                constexpr qsizetype kChunk = 1 << 20;
                if (peer.bytesToWrite() < kChunk) {
                    peer.write(QByteArray(kChunk, ' '));
                }
            });
        }
    }

    QTcpServer m_server;
    quint16 m_port = 0;
    std::map<std::string, Answer> m_answers;
    std::vector<std::string> m_questions;
};

}  // namespace boresight::fakes
