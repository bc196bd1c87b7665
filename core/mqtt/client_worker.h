// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/paced_outlet.h"
#include "core/mqtt/broker_client.h"
#include "core/mqtt/newest_messages.h"
#include "core/mqtt/threaded_client.h"

#include <QObject>

// The part of ThreadedClient on the other thread: a BrokerClient, and the reports about it.
namespace boresight::mqtt {

class ClientWorker final : public QObject
{
    Q_OBJECT

public:
    explicit ClientWorker(const Clock& clock);

    void open(int opening, const Broker& broker, const std::optional<Message>& will);
    void close(int opening);
    [[nodiscard]] BrokerClient& client() { return m_client; }
    void keepUrgent(const UrgencyOf& urgencyOf) { m_messages.keepUrgent(urgencyOf); }
    // The owner has read the last report.
    void taken() { m_outlet.taken(); }

Q_SIGNALS:
    void reported(const boresight::mqtt::ClientReport& report);

private:
    void begin(int opening);
    void report();

    BrokerClient m_client;
    ClientReport m_next;
    NewestMessages m_messages;
    PacedOutlet m_outlet;
};

}  // namespace boresight::mqtt
