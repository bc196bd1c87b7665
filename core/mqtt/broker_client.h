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

// An MQTT broker, as long as somebody wants it: connects, comes back by itself with growing delays, renews the
// subscriptions, and reports in one line what is wrong. Messages go to the receivers of a signal. Lives in its owner's
// event loop; nothing blocks: names are looked up by Qt's helpers, the rest is BrokerSession's.
//
// What is published while there is no connection is lost: nobody wants to know later where the mount was.
namespace boresight::mqtt {

class BrokerSession;

class BrokerClient : public Connection
{
    Q_OBJECT

public:
    // A connection that lasted so long was a good one, and the delays begin again after it.
    static constexpr std::chrono::seconds kStable{10};
    static constexpr std::chrono::milliseconds kServicePeriod{250};
    // A subscription that is refused is asked for again: somebody may correct the access list of the broker.
    static constexpr std::chrono::seconds kAskAgain{30};

    // `clock` outlives the client.
    explicit BrokerClient(const Clock& clock, QObject* parent = nullptr);
    // Without close(): as if the program had died, so that the broker publishes the will.
    ~BrokerClient() override;

    // From now on. With another broker or will than before the connection is made again.
    void open(const Broker& broker, const std::optional<Message>& will = std::nullopt);
    void close();

    void subscribe(const QString& filter) override;
    void unsubscribe(const QString& filter) override;
    bool publish(const Message& message) override;

    [[nodiscard]] const Broker& broker() const override { return m_broker; }
    [[nodiscard]] bool isConnected() const override { return m_connectedAt.has_value(); }
    [[nodiscard]] const QString& problem() const override { return m_problem; }

    // Empty while there is a connection or an attempt at one.
    [[nodiscard]] const std::optional<SteadyTime>& nextAttempt() const { return m_nextAttempt; }

    // What the timer calls; tests with a hand-turned clock call it themselves.
    void service();

Q_SIGNALS:
    // nextAttempt() is another.
    void nextAttemptChanged();

private Q_SLOTS:
    void takeLookup(const QHostInfo& found);

private:
    struct Subscriptions
    {
        QStringList wanted;
        QStringList refused;  // of them, by this connection
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
    int m_lookup = -1;                // Qt's number of it
    QList<QHostAddress> m_addresses;  // of the attempt, still untried
    std::shared_ptr<TlsContext> m_tls;
    BrokerSession* m_session = nullptr;  // a child; replaced at each attempt
    std::optional<SteadyTime> m_connectedAt;
    QString m_problem;
};

}  // namespace boresight::mqtt
