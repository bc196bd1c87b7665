// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inputs/message_inlet.h"

namespace boresight {

MessageInlet::MessageInlet(const QString& name, StationBroker& broker, QObject* parent)
    : QObject(parent), m_name(name), m_broker(broker)
{
    connect(&m_broker.connection(), &mqtt::Connection::messageReceived, this, &MessageInlet::takeMessage);
}

void MessageInlet::openPort(const QString& host, std::uint16_t port)
{
    close();
    m_port = std::make_unique<datagrams::DatagramPort>(m_name, host, port);
    connect(m_port.get(), &datagrams::DatagramPort::received, this, &MessageInlet::received);
}

void MessageInlet::openTopic(const QString& topic)
{
    close();
    m_topic = topic;
    m_broker.connection().subscribe(m_topic);
    m_broker.addReader();
}

void MessageInlet::openPage(const QUrl& url, std::chrono::milliseconds period)
{
    close();
    m_page = std::make_unique<page::PagePoll>(m_name, url, period);
    connect(m_page.get(), &page::PagePoll::received, this, &MessageInlet::received);
}

void MessageInlet::close()
{
    m_port.reset();
    m_page.reset();
    if (!m_topic.isEmpty()) {
        m_broker.connection().unsubscribe(m_topic);
        m_topic.clear();
        m_broker.removeReader();
    }
}

QString MessageInlet::trouble() const
{
    if (m_port) {
        return m_port->trouble();
    }
    if (m_page) {
        return m_page->trouble();
    }
    return m_topic.isEmpty() ? QString() : m_broker.status().problem;
}

void MessageInlet::takeMessage(const QString& topic, const QByteArray& payload, mqtt::Retain retain)
{
    if (!m_topic.isEmpty() && topic == m_topic && retain == mqtt::Retain::No) {
        Q_EMIT received(payload);
    }
}

}  // namespace boresight

#include "moc_message_inlet.cpp"
