// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/mqtt/broker.h"
#include "core/mqtt/ending.h"
#include "core/mqtt/inlet.h"
#include "core/mqtt/tls_context.h"

#include <QHostAddress>
#include <QObject>
#include <QSocketNotifier>

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

struct mosquitto;  // libmosquitto's client

// One connection to a broker, from the first packet to its end. Each connection has its own BrokerSession. MQTT 3.1.1,
// quality of service 0, clean session. broker_session.cpp is the only user of libmosquitto. Lives in the event loop of
// its owner. No thread, never blocks.
//
// libmosquitto does not detect these cases: an encrypted connection that is refused, a broker that accepts the
// connection and is silent, and a broker that closes it during the TLS handshake. So this class watches the socket,
// too, and has a deadline.
namespace boresight::mqtt {

class BrokerSession : public QObject
{
    Q_OBJECT

public:
    // The longest time from open() until the broker accepts the login.
    static constexpr std::chrono::seconds kPatience{10};
    // After this time of silence the broker is asked for a sign of life. Without an answer in the same time again, it
    // is given up.
    static constexpr std::chrono::seconds kKeepAlive{15};

    // `tls` is empty without encryption. The broker publishes `will` when the connection ends without goodbye().
    BrokerSession(const Broker& broker, std::shared_ptr<TlsContext> tls, const std::optional<Message>& will,
                  const Clock& clock, QObject* parent = nullptr);
    // Without goodbye() before, the broker publishes the will.
    ~BrokerSession() override;

    // Reports a failure later by ended().
    void open(const QHostAddress& address);
    void goodbye();
    // Closes the connection. No signal is emitted after this, not even ended().
    void drop();

    // For an accepted session. False if the connection is lost, which ended() also reports.
    bool publish(const Message& message);
    bool subscribe(const QString& filter);
    bool unsubscribe(const QString& filter);

    // Checks deadlines and the keep-alive. Call it a few times per second.
    void service();

Q_SIGNALS:
    void accepted();
    void received(const QString& topic, const QByteArray& payload, boresight::mqtt::Retain retain);
    void subscriptionAnswered(const QString& filter, bool granted);
    // A message of more than kLargestMessage bytes came and was dropped.
    void dropped(qint64 bytes);
    void ended(const boresight::mqtt::Ending& ending);

private:
    enum class Phase
    {
        Connecting,
        Greeting,  // connected: TLS handshake, CONNECT, CONNACK
        Accepted,
        Ended
    };
    // The reports of libmosquitto while it runs. They are handled after it has returned, because it must not be
    // destroyed before.
    struct Told
    {
        std::optional<int> answer;
        std::vector<Message> inbox;
        std::optional<qint64> dropped;  // with encryption: the size of a message that was too large
        std::vector<std::pair<int, bool>> granted;
        QString tlsError;
    };
    struct Callbacks;
    struct Destroy
    {
        void operator()(mosquitto* handle) const;
    };

    [[nodiscard]] bool prepare();
    void socketWritable();
    void pump();
    void settle(int result);
    void deliver();
    void tellDropped();
    [[nodiscard]] Ending endingOf(int result) const;
    [[nodiscard]] static EndKind kindOfRefusal(int code);
    void watch();
    void end(const Ending& ending);

    Broker m_broker;
    std::shared_ptr<TlsContext> m_tls;
    std::optional<Message> m_will;
    const Clock& m_clock;
    std::unique_ptr<mosquitto, Destroy> m_handle;
    QSocketNotifier m_readable;
    QSocketNotifier m_writable;
    Inlet m_inlet;  // used without encryption
    Phase m_phase = Phase::Connecting;
    SteadyTime m_opened{};
    Told m_told;
    std::map<int, QString> m_asked;  // filters without an answer yet, by the number of their packet
};

}  // namespace boresight::mqtt
