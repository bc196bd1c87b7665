// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/datagrams/datagram_port.h"
#include "core/page_poll/page_poll.h"
#include "core/station/station_broker.h"

#include <QObject>

#include <memory>

// Short messages for one reader, from a UDP port of this computer, a topic of the broker, or a page of a web server
// that is read again and again. Station thread. Port, broker and page have threads of their own.
namespace boresight {

class MessageInlet : public QObject
{
    Q_OBJECT

public:
    // The broker outlives this. `name` is that of the thread of a port or a page.
    MessageInlet(const QString& name, StationBroker& broker, QObject* parent);

    // Each closes what was open before.
    void openPort(const QString& host, std::uint16_t port);
    void openTopic(const QString& topic);
    void openPage(const QUrl& url, std::chrono::milliseconds period);
    void close();
    // Why no message arrives; empty: nothing is wrong, or it is closed.
    [[nodiscard]] QString trouble() const;

Q_SIGNALS:
    // A message that the broker has kept is of some time before, and is left out.
    void received(const QByteArray& message);

private:
    void takeMessage(const QString& topic, const QByteArray& payload, mqtt::Retain retain);

    QString m_name;
    StationBroker& m_broker;
    // At most one of them is there.
    std::unique_ptr<datagrams::DatagramPort> m_port;
    std::unique_ptr<page::PagePoll> m_page;
    QString m_topic;  // subscribed to; empty: none
};

}  // namespace boresight
