// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHostAddress>
#include <QObject>
#include <QTimer>
#include <QUdpSocket>

#include <chrono>
#include <cstdint>

// A UDP port that others can flood. It reads a batch of datagrams at a time, and pauses after a full batch. Meanwhile
// the kernel drops datagrams for which it has no room. Any thread with an event loop.
namespace boresight::datagrams {

class DatagramInlet final : public QObject
{
    Q_OBJECT

public:
    static constexpr std::chrono::milliseconds kPause{10};
    static constexpr qint64 kWhole = 65'535;  // bytes; no datagram is longer

    // `atOnce`: datagrams in a batch. Of each datagram at most `longest` bytes are read.
    DatagramInlet(int atOnce, qint64 longest, QObject* parent = nullptr);
    ~DatagramInlet() override;

    // `shared`: other programs may have the port too. A broadcast reaches all of them.
    [[nodiscard]] bool open(const QHostAddress& host, std::uint16_t port, bool shared);
    [[nodiscard]] QString trouble() const { return m_socket.errorString(); }
    // The address and port at which it listens.
    [[nodiscard]] QHostAddress host() const { return m_socket.localAddress(); }
    [[nodiscard]] std::uint16_t port() const { return m_socket.localPort(); }
    // Sends from this port.
    void send(const QByteArray& bytes, const QHostAddress& host, std::uint16_t port);

Q_SIGNALS:
    void received(const QByteArray& bytes, const QHostAddress& host, std::uint16_t port);

private:
    void readSome();

    int m_atOnce;
    qint64 m_longest;
    QUdpSocket m_socket{this};
    QTimer m_pause{this};
};

}  // namespace boresight::datagrams
