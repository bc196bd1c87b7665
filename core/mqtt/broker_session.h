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

// One connection to a broker, from the first packet to its end; for the next one a new BrokerSession is made.
// MQTT 3.1.1, quality of service 0, clean. broker_session.cpp is the only user of libmosquitto. Lives in its owner's
// event loop: no thread, nothing blocks.
//
// libmosquitto does not notice everything by itself: a refused encrypted connection, a broker that takes the connection
// and is silent, one that hangs up in the middle of the TLS handshake. So the socket is watched here as well, and there
// is a deadline.
namespace boresight::mqtt {

class BrokerSession : public QObject
{
    Q_OBJECT

public:
    // From the first packet to the broker's consent.
    static constexpr std::chrono::seconds kPatience{10};
    // A broker that is silent for so long is asked, and given up if it does not answer for as long again.
    static constexpr std::chrono::seconds kKeepAlive{15};

    // `tls` is empty without encryption; `will` is what the broker publishes when the connection ends without
    // goodbye().
    BrokerSession(const Broker& broker, std::shared_ptr<TlsContext> tls, const std::optional<Message>& will,
                  const Clock& clock, QObject* parent = nullptr);
    // Without goodbye(): the broker then publishes the will.
    ~BrokerSession() override;

    // ended() reports later that it did not work.
    void open(const QHostAddress& address);
    void goodbye();
    // Without ended() and any other signal from here on.
    void drop();

    // While accepted; false if the broker is gone, which ended() reports too.
    bool publish(const Message& message);
    bool subscribe(const QString& filter);
    bool unsubscribe(const QString& filter);

    // Deadlines and the keep-alive: to be called some times a second.
    void service();

Q_SIGNALS:
    void accepted();
    void received(const QString& topic, const QByteArray& payload, boresight::mqtt::Retain retain);
    void subscriptionAnswered(const QString& filter, bool granted);
    // A message of more than kLargestMessage came and is thrown away.
    void dropped(qint64 bytes);
    void ended(const boresight::mqtt::Ending& ending);

private:
    enum class Phase
    {
        Connecting,
        Greeting,  // connected; TLS handshake, CONNECT, CONNACK
        Accepted,
        Ended
    };
    // What libmosquitto reported while it ran: acted upon when it has returned, for it must not be destroyed before.
    struct Told
    {
        std::optional<int> answer;
        std::vector<Message> inbox;
        std::optional<qint64> dropped;  // the size of a message that was too large; with encryption
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
    Inlet m_inlet;  // without encryption
    Phase m_phase = Phase::Connecting;
    SteadyTime m_opened{};
    Told m_told;
    std::map<int, QString> m_asked;  // filters that no answer has come to yet, by the number of their packet
};

}  // namespace boresight::mqtt
