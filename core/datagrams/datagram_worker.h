// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/paced_outlet.h"
#include "core/datagrams/datagram_inlet.h"
#include "core/datagrams/datagram_port.h"

#include <QTimer>

#include <cstdint>
#include <deque>

// The part of DatagramPort on the other thread: the port, and the reports.
namespace boresight::datagrams {

class DatagramWorker final : public QObject
{
    Q_OBJECT

public:
    static constexpr int kDatagramsAtOnce = 64;
    static constexpr std::chrono::seconds kRetry{2};

    DatagramWorker(const QString& host, std::uint16_t port);
    ~DatagramWorker() override;

    void open();
    // The owner has read the last report.
    void taken() { m_outlet.taken(); }

Q_SIGNALS:
    void reported(const boresight::datagrams::PortReport& report);

private:
    void take(const QByteArray& bytes);
    void report();

    QString m_host;
    std::uint16_t m_port;
    DatagramInlet m_inlet;
    QTimer m_retry{this};
    QString m_trouble;
    std::deque<QByteArray> m_read;  // at most DatagramPort::kMost
    PacedOutlet m_outlet;
};

}  // namespace boresight::datagrams
