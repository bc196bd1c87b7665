// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/edge_thread.h"
#include "core/position/position_text.h"

#include <QObject>
#include <QString>

#include <cstdint>
#include <vector>

// The UDP port at which positions of a balloon or a rocket arrive, on a thread of its own: whoever floods the port
// delays nobody. The owner gets at most kMost messages each PacedOutlet::kPeriod, the newest ones, already read.
// Station thread.
namespace boresight::position {

class DatagramWorker;

struct PortReport
{
    bool open = false;
    QString trouble = {};                         // why it does not listen
    std::vector<Result<PositionText>> read = {};  // since the last report, oldest first
};

class PositionPort final : public QObject
{
    Q_OBJECT

public:
    static constexpr std::size_t kMost = 32;

    // Listens at once, and tries again each 2 s where it cannot. `host` is an address of this computer.
    PositionPort(const QString& host, std::uint16_t port, QObject* parent = nullptr);
    ~PositionPort() override;

    // Empty: it listens, or has just begun to.
    [[nodiscard]] const QString& trouble() const { return m_trouble; }

Q_SIGNALS:
    void received(const boresight::Result<boresight::position::PositionText>& read);

private:
    void take(const PortReport& report);

    QString m_trouble;
    DatagramWorker* m_worker;  // lives on m_thread and belongs to it
    EdgeThread m_thread;
};

}  // namespace boresight::position
