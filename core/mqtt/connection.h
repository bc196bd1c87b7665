// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mqtt/broker.h"

#include <QObject>

// The connection to a broker for those who subscribe, publish and read. Somebody else opens it. BrokerClient runs in
// the event loop of its owner, ThreadedClient on its own thread.
namespace boresight::mqtt {

class Connection : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    // Survives reconnects and other brokers. Each topic has one reader: two of one topic are not counted.
    virtual void subscribe(const QString& filter) = 0;
    virtual void unsubscribe(const QString& filter) = 0;
    // False: not connected.
    virtual bool publish(const Message& message) = 0;

    [[nodiscard]] virtual const Broker& broker() const = 0;
    [[nodiscard]] virtual bool isConnected() const = 0;
    // One line for the operator; empty while connected or closed, and before it is known.
    [[nodiscard]] virtual const QString& problem() const = 0;

Q_SIGNALS:
    void connected();
    // Retain::Yes: kept by the broker, said by somebody some time before we came.
    void messageReceived(const QString& topic, const QByteArray& payload, boresight::mqtt::Retain retain);
    // Once in each connection, however often it is asked for. There are brokers that grant what they then never send.
    void subscriptionRefused(const QString& filter);
    // Only of one that was refused before.
    void subscriptionGranted(const QString& filter);
    // A message of more than kLargestMessage bytes came and was dropped. `bytes` is its size.
    void messageDropped(qint64 bytes);
    // Once for each new trouble, however often it is tried again; empty when it is over.
    void problemChanged(const QString& problem);
};

}  // namespace boresight::mqtt
