// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/datagrams/datagram_worker.h"

#include "core/base/text.h"

#include <QNetworkDatagram>
#include <QNetworkProxy>

#include <utility>

namespace boresight::datagrams {

DatagramWorker::DatagramWorker(const QString& host, std::uint16_t port)
    : m_host(host), m_port(port), m_outlet(this, [this] { report(); })
{
    m_socket.setProxy(QNetworkProxy::NoProxy);  // a query of the desktop for its proxy would block
    m_retry.setSingleShot(true);
    m_retry.setInterval(kRetry);
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPause);
    connect(&m_retry, &QTimer::timeout, this, &DatagramWorker::open);
    connect(&m_pause, &QTimer::timeout, this, &DatagramWorker::readSome);
    connect(&m_socket, &QUdpSocket::readyRead, this, &DatagramWorker::readSome);
}

DatagramWorker::~DatagramWorker()
{
    m_socket.disconnect(this);
}

// A broadcast reaches every program that shares the port.
void DatagramWorker::open()
{
    const QHostAddress address(m_host);
    const QAbstractSocket::BindMode mode = address.isLoopback()
                                               ? QAbstractSocket::DontShareAddress
                                               : QAbstractSocket::ShareAddress | QAbstractSocket::ReuseAddressHint;
    if (m_socket.bind(address, m_port, mode)) {
        m_trouble.clear();
    } else {
        m_trouble =
            Text::tr("Boresight cannot listen on UDP %1:%2: %3").arg(m_host).arg(m_port).arg(m_socket.errorString());
        m_retry.start();
    }
    m_outlet.ask();
}

// A full batch is followed by a pause. Meanwhile the kernel drops datagrams for which it has no room.
void DatagramWorker::readSome()
{
    if (m_pause.isActive()) {
        return;
    }
    int count = 0;
    for (; count < kDatagramsAtOnce && m_socket.hasPendingDatagrams(); ++count) {
        m_read.push_back(m_socket.receiveDatagram(DatagramPort::kLongest + 1).data());
        if (m_read.size() > DatagramPort::kMost) {
            m_read.pop_front();
        }
    }
    if (count == kDatagramsAtOnce) {
        m_pause.start();
    }
    m_outlet.ask();
}

void DatagramWorker::report()
{
    const auto read = std::exchange(m_read, {});
    Q_EMIT reported({.open = m_trouble.isEmpty(), .trouble = m_trouble, .datagrams = {read.begin(), read.end()}});
}

}  // namespace boresight::datagrams

#include "moc_datagram_worker.cpp"
