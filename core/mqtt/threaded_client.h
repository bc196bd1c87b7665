// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/edge_thread.h"
#include "core/mqtt/connection.h"
#include "core/mqtt/newest_messages.h"

#include <QObject>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

// A BrokerClient on a thread of its own, for an owner whose thread must not wait for a broker (station thread). However
// much a broker sends, the owner gets at most NewestMessages::kMost messages in each PacedOutlet::kPeriod, the newest
// ones. Requests of the owner are queued to the thread, so the owner never waits. The first request starts the thread.
namespace boresight::mqtt {

class ClientWorker;

// The state of the connection, and the messages since the last report.
struct ClientReport
{
    int opening = 0;      // number of the open() or close() that this report belongs to
    int connections = 0;  // number of connections since then
    bool connected = false;
    QString problem;
    std::optional<SteadyTime> nextAttempt;
    std::optional<qint64> dropped;                  // bytes: size of the last message that was too large
    std::vector<std::pair<QString, bool>> answers;  // answers to subscriptions: granted or refused
    std::vector<Message> messages;
};

class ThreadedClient final : public Connection
{
    Q_OBJECT

public:
    // `clock` outlives the client and may be read by any thread.
    explicit ThreadedClient(const Clock& clock, QObject* parent = nullptr);
    // Carries out all queued requests first, close() included. Without close() the broker publishes the will.
    ~ThreadedClient() override;

    // Like BrokerClient. isConnected() is false until the thread reports the new connection.
    void open(const Broker& broker, const std::optional<Message>& will = std::nullopt);
    void close();

    void subscribe(const QString& filter) override;
    void unsubscribe(const QString& filter) override;
    bool publish(const Message& message) override;

    // No flood displaces a hold or a STOP. The function is called on the other thread. An empty one ends this.
    void keepUrgent(UrgencyOf urgencyOf);

    // The values of the last report.
    [[nodiscard]] const Broker& broker() const override { return m_broker; }
    [[nodiscard]] bool isConnected() const override { return m_last.connected; }
    [[nodiscard]] const QString& problem() const override { return m_last.problem; }
    [[nodiscard]] const std::optional<SteadyTime>& nextAttempt() const { return m_last.nextAttempt; }

private:
    void begin();
    void forget();
    void take(const ClientReport& report);
    void deliver(const ClientReport& report);

    const Clock& m_clock;
    bool m_wanted = false;
    Broker m_broker;
    std::optional<Message> m_will;
    ClientReport m_last;               // without its messages
    ClientWorker* m_worker = nullptr;  // lives on m_thread and belongs to it
    std::unique_ptr<EdgeThread> m_thread;
};

}  // namespace boresight::mqtt
