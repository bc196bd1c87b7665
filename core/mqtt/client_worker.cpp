// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mqtt/client_worker.h"

#include <utility>

namespace boresight::mqtt {

ClientWorker::ClientWorker(const Clock& clock) : m_client(clock, this), m_outlet(this, [this] { report(); })
{
    const auto ask = [this] { m_outlet.ask(); };
    connect(&m_client, &BrokerClient::problemChanged, this, ask);
    connect(&m_client, &BrokerClient::nextAttemptChanged, this, ask);
    connect(&m_client, &BrokerClient::connected, this, [this] {
        ++m_next.connections;
        m_outlet.ask();
    });
    connect(&m_client, &BrokerClient::messageDropped, this, [this](qint64 bytes) {
        m_next.dropped = bytes;
        m_outlet.ask();
    });
    const auto answer = [this](const QString& filter, bool granted) {
        m_next.answers.emplace_back(filter, granted);
        m_outlet.ask();
    };
    connect(&m_client, &BrokerClient::subscriptionRefused, this,
            [answer](const QString& filter) { answer(filter, false); });
    connect(&m_client, &BrokerClient::subscriptionGranted, this,
            [answer](const QString& filter) { answer(filter, true); });
    connect(&m_client, &BrokerClient::messageReceived, this,
            [this](const QString& topic, const QByteArray& payload, Retain retain) {
                m_messages.add({.topic = topic, .payload = payload, .retain = retain});
                m_outlet.ask();
            });
}

void ClientWorker::open(int opening, const Broker& broker, const std::optional<Message>& will)
{
    begin(opening);
    m_client.open(broker, will);
}

void ClientWorker::close(int opening)
{
    begin(opening);
    m_client.close();
}

// Drops what was not reported yet, because it belongs to the previous connection.
void ClientWorker::begin(int opening)
{
    m_next = {.opening = opening};
    (void)m_messages.take();
}

void ClientWorker::report()
{
    m_next.connected = m_client.isConnected();
    m_next.problem = m_client.problem();
    m_next.nextAttempt = m_client.nextAttempt();
    m_next.messages = m_messages.take();
    Q_EMIT reported(m_next);
    m_next = {.opening = m_next.opening, .connections = m_next.connections};
}

}  // namespace boresight::mqtt

#include "moc_client_worker.cpp"
