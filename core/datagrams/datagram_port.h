// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/edge_thread.h"

#include <QByteArray>
#include <QObject>
#include <QString>

#include <cstdint>
#include <vector>

// A UDP port at which short messages arrive, on a thread of its own: whoever floods the port delays nobody. The owner
// gets at most kMost datagrams each PacedOutlet::kPeriod, the newest ones. Station thread.
namespace boresight::datagrams {

class DatagramWorker;

struct PortReport
{
    bool open = false;
    QString trouble = {};               // why it does not listen
    std::vector<QByteArray> datagrams;  // since the last report, oldest first
};

class DatagramPort final : public QObject
{
    Q_OBJECT

public:
    static constexpr std::size_t kMost = 32;
    // Bytes. Of a longer datagram only one byte more than this arrives, so its reader can refuse it.
    static constexpr qint64 kLongest = 4096;

    // Listens at once, and tries again each 2 s where it cannot. `host` is an address of this computer. `name` is that
    // of the thread.
    DatagramPort(const QString& name, const QString& host, std::uint16_t port, QObject* parent = nullptr);
    ~DatagramPort() override;

    // Empty: it listens, or has just begun to.
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
