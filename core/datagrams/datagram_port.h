// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/edge_thread.h"

#include <QByteArray>
#include <QObject>
#include <QString>

#include <cstdint>
#include <vector>

// A UDP port for short messages, on a thread of its own, so that a flood of messages delays nobody. The owner gets at
// most kMost datagrams in each PacedOutlet::kPeriod, the newest ones. Station thread.
namespace boresight::datagrams {

class DatagramWorker;

struct PortReport
{
    bool open = false;
    QString trouble = {};               // why it does not listen
    std::vector<QByteArray> datagrams;  // since the last report, the oldest first
};

class DatagramPort final : public QObject
{
    Q_OBJECT

public:
    static constexpr std::size_t kMost = 32;
    // In bytes. Of a longer datagram, one byte more than this arrives, so that the reader can refuse it.
    static constexpr qint64 kLongest = 4096;

    // Listens at once. If that fails, it tries again every 2 s. `host`: an address of this computer. `name`: the name
    // of the thread.
    DatagramPort(const QString& name, const QString& host, std::uint16_t port, QObject* parent = nullptr);
    ~DatagramPort() override;

    // Why it does not listen. Empty while it listens or has just started.
    [[nodiscard]] const QString& trouble() const { return m_trouble; }

Q_SIGNALS:
    void received(const QByteArray& datagram);

private:
    void take(const PortReport& report);

    QString m_trouble;
    DatagramWorker* m_worker;  // lives on m_thread and belongs to it
    EdgeThread m_thread;
};

}  // namespace boresight::datagrams
