// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/datagrams/datagram_worker.h"

#include "core/base/text.h"

#include <utility>

namespace boresight::datagrams {

DatagramWorker::DatagramWorker(const QString& host, std::uint16_t port)
    : m_host(host),
      m_port(port),
      m_inlet(kDatagramsAtOnce, DatagramPort::kLongest + 1, this),
      m_outlet(this, [this] { report(); })
{
    m_retry.setSingleShot(true);
    m_retry.setInterval(kRetry);
    connect(&m_retry, &QTimer::timeout, this, &DatagramWorker::open);
    connect(&m_inlet, &DatagramInlet::received, this, &DatagramWorker::take);
}

DatagramWorker::~DatagramWorker() = default;

// A broadcast reaches every program that shares the port.
void DatagramWorker::open()
{
    const QHostAddress address(m_host);
    if (m_inlet.open(address, m_port, !address.isLoopback())) {
        m_trouble.clear();
    } else {
        m_trouble = Text::tr("Boresight cannot listen on UDP %1:%2: %3").arg(m_host).arg(m_port).arg(m_inlet.trouble());
        m_retry.start();
    }
    m_outlet.ask();
}

void DatagramWorker::take(const QByteArray& bytes)
{
    m_read.push_back(bytes);
    if (m_read.size() > DatagramPort::kMost) {
        m_read.pop_front();
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
