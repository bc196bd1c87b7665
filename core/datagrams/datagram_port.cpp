// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/datagrams/datagram_port.h"

#include "core/datagrams/datagram_worker.h"

namespace boresight::datagrams {

DatagramPort::DatagramPort(const QString& name, const QString& host, std::uint16_t port, QObject* parent)
    : QObject(parent), m_worker(new DatagramWorker(host, port)), m_thread(name, std::unique_ptr<QObject>(m_worker))
{
    connect(m_worker, &DatagramWorker::reported, this, &DatagramPort::take);
    m_thread.post([worker = m_worker] { worker->open(); });
}

DatagramPort::~DatagramPort() = default;

void DatagramPort::take(const PortReport& report)
{
    m_thread.post([worker = m_worker] { worker->taken(); });
    m_trouble = report.trouble;
    for (const QByteArray& datagram : report.datagrams) {
        Q_EMIT received(datagram);
    }
}

}  // namespace boresight::datagrams

#include "moc_datagram_port.cpp"
