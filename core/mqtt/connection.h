// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mqtt/broker.h"

#include <QObject>

// The connection to a broker for classes that subscribe, publish and read. Another class opens it. BrokerClient runs in
// the event loop of its owner, ThreadedClient on a thread of its own.
namespace boresight::mqtt {

class Connection : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    // A subscription survives reconnects and a change of the broker. A topic may have only one subscriber.
    virtual void subscribe(const QString& filter) = 0;
    virtual void unsubscribe(const QString& filter) = 0;
    // False if there is no connection.
    virtual bool publish(const Message& message) = 0;

    [[nodiscard]] virtual const Broker& broker() const = 0;
    [[nodiscard]] virtual bool isConnected() const = 0;
    // One line for the operator. Empty while connected or closed, and before a problem is known.
    [[nodiscard]] virtual const QString& problem() const = 0;

Q_SIGNALS:
    void connected();
    // Retain::Yes: the broker stored the message, and it was sent before we subscribed.
    void messageReceived(const QString& topic, const QByteArray& payload, boresight::mqtt::Retain retain);
    // Once in each connection, even if the subscription is repeated. Some brokers grant subscriptions and then send
    // nothing.
    void subscriptionRefused(const QString& filter);
    // Only after a refusal of the same subscription.
    void subscriptionGranted(const QString& filter);
    // A message of more than kLargestMessage bytes came and was dropped. `bytes` is its size.
    void messageDropped(qint64 bytes);
    // Once for each new problem, even if the connection is tried again and again. Empty when the problem is over.
    void problemChanged(const QString& problem);
};

}  // namespace boresight::mqtt
