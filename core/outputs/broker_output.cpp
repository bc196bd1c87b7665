// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outputs/broker_output.h"

namespace boresight::outputs {
namespace {

mqtt::Message messageOf(const QString& topic, bool on)
{
    return on ? mqtt::Message{.topic = topic, .payload = "on", .retain = mqtt::Retain::No}
              : mqtt::Message{.topic = topic, .payload = "off", .retain = mqtt::Retain::Yes};
}

}  // namespace

BrokerOutput::BrokerOutput(const mqtt::Broker& broker, const QString& topic, const Clock& clock, QObject* parent)
    : Output(parent), m_topic(topic), m_client(clock)
{
    connect(&m_client, &mqtt::Connection::connected, this, &BrokerOutput::publish);
    connect(&m_client, &mqtt::Connection::problemChanged, this, [this](const QString& problem) {
        if (!problem.isEmpty()) {
            Q_EMIT failed(problem);
        }
    });
    m_client.open(broker, messageOf(topic, false));
}

BrokerOutput::~BrokerOutput()
{
    m_client.disconnect(this);
    m_client.close();
}

void BrokerOutput::set(bool on)
{
    m_wanted = on;
    publish();
}

// Emits nothing while the client is still connecting: then there is neither a connection nor a problem.
void BrokerOutput::publish()
{
    if (m_client.publish(messageOf(m_topic, m_wanted))) {
        Q_EMIT reached(m_wanted);
    } else if (!m_client.problem().isEmpty()) {
        Q_EMIT failed(m_client.problem());
    }
}

}  // namespace boresight::outputs

#include "moc_broker_output.cpp"
