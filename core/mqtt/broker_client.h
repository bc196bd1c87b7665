// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/mqtt/connection.h"
#include "core/mqtt/ending.h"
#include "core/mqtt/retry_delay.h"
#include "core/mqtt/tls_context.h"

#include <QHostAddress>
#include <QHostInfo>
#include <QStringList>
#include <QTimer>

#include <memory>
#include <optional>

// The connection to an MQTT broker while its owner wants one. Connects, reconnects by itself with growing delays,
// renews the subscriptions, and reports in one line what is wrong. Received messages are emitted as a signal. Lives in
// the event loop of its owner. Never blocks: Qt looks names up in the background, and BrokerSession does the rest.
//
// Messages that are published without a connection are lost, because old positions of the mount are of no use.
namespace boresight::mqtt {

class BrokerSession;

class BrokerClient : public Connection
{
    Q_OBJECT

public:
    // A connection that lasted this long was good. The delays then start from the first one again.
    static constexpr std::chrono::seconds kStable{10};
    static constexpr std::chrono::milliseconds kServicePeriod{250};
    // A refused subscription is repeated after this time, because somebody may have corrected the access list of the
    // broker.
    static constexpr std::chrono::seconds kAskAgain{30};

    // `clock` outlives the client.
    explicit BrokerClient(const Clock& clock, QObject* parent = nullptr);
    // Without close() before, the connection ends as if the program had died, and the broker publishes the will.
    ~BrokerClient() override;

    // Wants a connection from now on. If the broker or the will differ from before, the connection is made again.
    void open(const Broker& broker, const std::optional<Message>& will = std::nullopt);
    void close();

    void subscribe(const QString& filter) override;
    void unsubscribe(const QString& filter) override;
    bool publish(const Message& message) override;

    [[nodiscard]] const Broker& broker() const override { return m_broker; }
    [[nodiscard]] bool isConnected() const override { return m_connectedAt.has_value(); }
    [[nodiscard]] const QString& problem() const override { return m_problem; }

    // Empty during a connection or an attempt.
    [[nodiscard]] const std::optional<SteadyTime>& nextAttempt() const { return m_nextAttempt; }

    // The timer calls this. Tests with a hand-turned clock call it themselves.
    void service();

Q_SIGNALS:
    // nextAttempt() has changed.
    void nextAttemptChanged();

private Q_SLOTS:
    void takeLookup(const QHostInfo& found);

private:
    struct Subscriptions
    {
        QStringList wanted;
        QStringList refused;  // the wanted ones that this connection refused
        SteadyTime askAgainAt{};
    };

    void attempt();
    [[nodiscard]] Result<> prepareTls();
    void lookUp();
    void tryNextAddress();
    void accepted();
    void takeAnswer(const QString& filter, bool granted);
    void askAgain();
    void ended(const Ending& ending);
    void giveUp(const Ending& ending);
    void dropAttempt();
    void setProblem(const QString& problem);

    const Clock& m_clock;
    bool m_wanted = false;
    Broker m_broker;
    std::optional<Message> m_will;
    Subscriptions m_subscriptions;
    QTimer m_timer;
    RetryDelay m_delay;
    std::optional<SteadyTime> m_nextAttempt;
    int m_lookup = -1;                // the number that Qt gave to the lookup; -1: none
    QList<QHostAddress> m_addresses;  // addresses of this attempt that were not tried yet
    std::shared_ptr<TlsContext> m_tls;
    BrokerSession* m_session = nullptr;  // a child; a new one for each attempt
    std::optional<SteadyTime> m_connectedAt;
    QString m_problem;
};

}  // namespace boresight::mqtt
