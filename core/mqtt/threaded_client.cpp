// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mqtt/threaded_client.h"

#include "core/mqtt/client_worker.h"

#include <utility>

namespace boresight::mqtt {

ThreadedClient::ThreadedClient(const Clock& clock, QObject* parent) : Connection(parent), m_clock(clock) {}

ThreadedClient::~ThreadedClient() = default;

void ThreadedClient::begin()
{
    if (m_thread) {
        return;
    }
    auto worker = std::make_unique<ClientWorker>(m_clock);
    m_worker = worker.get();
    connect(m_worker, &ClientWorker::reported, this, &ThreadedClient::take);
    m_thread = std::make_unique<EdgeThread>(QStringLiteral("mqtt"), std::move(worker));
}

void ThreadedClient::open(const Broker& broker, const std::optional<Message>& will)
{
    if (m_wanted && broker == m_broker && will == m_will) {
        return;
    }
    begin();
    m_wanted = true;
    m_broker = broker;
    m_will = will;
    forget();
    m_thread->post(
        [worker = m_worker, opening = m_last.opening, broker, will] { worker->open(opening, broker, will); });
}

void ThreadedClient::close()
{
    if (!m_wanted) {
        return;
    }
    m_wanted = false;
    forget();
    m_thread->post([worker = m_worker, opening = m_last.opening] { worker->close(opening); });
}

// Reports that are still on their way belong to the previous connection.
void ThreadedClient::forget()
{
    const bool hadProblem = !m_last.problem.isEmpty();
    m_last = {.opening = m_last.opening + 1};
    if (hadProblem) {
        Q_EMIT problemChanged({});
    }
}

void ThreadedClient::subscribe(const QString& filter)
{
    begin();
    m_thread->post([worker = m_worker, filter] { worker->client().subscribe(filter); });
}

void ThreadedClient::unsubscribe(const QString& filter)
{
    begin();
    m_thread->post([worker = m_worker, filter] { worker->client().unsubscribe(filter); });
}

void ThreadedClient::keepUrgent(UrgencyOf urgencyOf)
{
    begin();
    m_thread->post([worker = m_worker, urgencyOf = std::move(urgencyOf)] { worker->keepUrgent(urgencyOf); });
}

bool ThreadedClient::publish(const Message& message)
{
    if (!m_last.connected) {
        return false;
    }
    m_thread->post([worker = m_worker, message] { worker->client().publish(message); });
    return true;
}

void ThreadedClient::take(const ClientReport& report)
{
    m_thread->post([worker = m_worker] { worker->taken(); });
    if (report.opening == m_last.opening) {
        deliver(report);
    }
}

// A receiver may close the connection or open another one in between.
void ThreadedClient::deliver(const ClientReport& report)
{
    const auto isStill = [this, &report] { return m_last.opening == report.opening; };
    const bool isNewConnection = report.connected && report.connections != m_last.connections;
    const bool isNewProblem = report.problem != m_last.problem;
    m_last = report;
    m_last.messages.clear();
    if (isNewProblem) {
        Q_EMIT problemChanged(report.problem);
    }
    if (isNewConnection && isStill()) {
        Q_EMIT connected();
    }
    for (const auto& [filter, isGranted] : report.answers) {
        if (isStill()) {
            isGranted ? Q_EMIT subscriptionGranted(filter) : Q_EMIT subscriptionRefused(filter);
        }
    }
    if (report.dropped && isStill()) {
        Q_EMIT messageDropped(*report.dropped);
    }
    for (const Message& message : report.messages) {
        if (isStill()) {
            Q_EMIT messageReceived(message.topic, message.payload, message.retain);
        }
    }
}

}  // namespace boresight::mqtt

#include "moc_threaded_client.cpp"
