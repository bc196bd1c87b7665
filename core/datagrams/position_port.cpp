// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/datagrams/position_port.h"

#include "core/datagrams/datagram_worker.h"

namespace boresight::position {

PositionPort::PositionPort(const QString& host, std::uint16_t port, QObject* parent)
    : QObject(parent),
      m_worker(new DatagramWorker(host, port)),
      m_thread(QStringLiteral("position"), std::unique_ptr<QObject>(m_worker))
{
    connect(m_worker, &DatagramWorker::reported, this, &PositionPort::take);
    m_thread.post([worker = m_worker] { worker->open(); });
}

PositionPort::~PositionPort() = default;

void PositionPort::take(const PortReport& report)
{
    m_thread.post([worker = m_worker] { worker->taken(); });
    m_trouble = report.trouble;
    for (const Result<PositionText>& read : report.read) {
        Q_EMIT received(read);
    }
}

}  // namespace boresight::position

#include "moc_position_port.cpp"
