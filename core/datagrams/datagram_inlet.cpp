// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/datagrams/datagram_inlet.h"

#include <QNetworkDatagram>
#include <QNetworkProxy>

namespace boresight::datagrams {

DatagramInlet::DatagramInlet(int atOnce, qint64 longest, QObject* parent)
    : QObject(parent), m_atOnce(atOnce), m_longest(longest)
{
    m_socket.setProxy(QNetworkProxy::NoProxy);  // a query of the desktop for its proxy would block
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPause);
    connect(&m_pause, &QTimer::timeout, this, &DatagramInlet::readSome);
    connect(&m_socket, &QUdpSocket::readyRead, this, &DatagramInlet::readSome);
}

DatagramInlet::~DatagramInlet()
{
    m_socket.disconnect(this);
}

// "::" serves IPv4 as well.
bool DatagramInlet::open(const QHostAddress& host, std::uint16_t port, bool shared)
{
    const bool isAny = host == QHostAddress(QHostAddress::AnyIPv6);
    return m_socket.bind(isAny ? QHostAddress(QHostAddress::Any) : host, port,
                         shared ? QAbstractSocket::ShareAddress | QAbstractSocket::ReuseAddressHint
                                : QAbstractSocket::BindMode(QAbstractSocket::DontShareAddress));
}

void DatagramInlet::send(const QByteArray& bytes, const QHostAddress& host, std::uint16_t port)
{
    m_socket.writeDatagram(bytes, host, port);
}

void DatagramInlet::readSome()
{
    if (m_pause.isActive()) {
        return;
    }
    int count = 0;
    for (; count < m_atOnce && m_socket.hasPendingDatagrams(); ++count) {
        const QNetworkDatagram datagram = m_socket.receiveDatagram(m_longest);
        Q_EMIT received(datagram.data(), datagram.senderAddress(), static_cast<std::uint16_t>(datagram.senderPort()));
    }
    if (count == m_atOnce) {
        m_pause.start();
    }
}

}  // namespace boresight::datagrams

#include "moc_datagram_inlet.cpp"
