// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/datagrams/datagram_port.h"
#include "core/inputs/station_broker.h"
#include "core/page_poll/page_poll.h"

#include <QObject>

#include <memory>

// Receives short messages for one reader. They come from a UDP port of this computer, a topic of the broker, or a page
// of a web server that is read periodically. Station thread. Port, broker and page have threads of their own.
namespace boresight {

class MessageInlet : public QObject
{
    Q_OBJECT

public:
    // The broker outlives this. The thread of a port or a page gets this `name`.
    MessageInlet(const QString& name, StationBroker& broker, QObject* parent);

    // Each of these closes the previous source.
    void openPort(const QString& host, std::uint16_t port);
    void openTopic(const QString& topic);
    void openPage(const QUrl& url, std::chrono::milliseconds period);
    void close();
    // Why no message arrives. Empty: there is no problem, or nothing is open.
    [[nodiscard]] QString trouble() const;

Q_SIGNALS:
    // Retained messages of the broker are left out, because their age is unknown.
    void received(const QByteArray& message);

private:
    void takeMessage(const QString& topic, const QByteArray& payload, mqtt::Retain retain);

    QString m_name;
    StationBroker& m_broker;
    // At most one of these three is in use.
    std::unique_ptr<datagrams::DatagramPort> m_port;
    std::unique_ptr<page::PagePoll> m_page;
    QString m_topic;  // the subscribed topic; empty: none
};

}  // namespace boresight
