// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mqtt/broker_client.h"

#include "core/mqtt/broker_session.h"

#include <utility>

namespace boresight::mqtt {

BrokerClient::BrokerClient(const Clock& clock, QObject* parent) : Connection(parent), m_clock(clock), m_timer(this)
{
    m_timer.setInterval(kServicePeriod);
    connect(&m_timer, &QTimer::timeout, this, &BrokerClient::service);
}

BrokerClient::~BrokerClient()
{
    dropAttempt();
}

void BrokerClient::open(const Broker& broker, const std::optional<Message>& will)
{
    if (m_wanted && broker == m_broker && will == m_will) {
        return;
    }
    close();
    m_wanted = true;
    m_broker = broker;
    m_will = will;
    m_timer.start();
    attempt();
}

void BrokerClient::close()
{
    if (m_session != nullptr) {
        m_session->goodbye();
    }
    dropAttempt();
    m_wanted = false;
    m_timer.stop();
    m_nextAttempt.reset();
    m_delay.reset();
    m_tls.reset();
    setProblem({});
}

void BrokerClient::subscribe(const QString& filter)
{
    if (!m_subscriptions.wanted.contains(filter)) {
        m_subscriptions.wanted.append(filter);
        if (isConnected()) {
            m_session->subscribe(filter);
        }
    }
}

void BrokerClient::unsubscribe(const QString& filter)
{
    m_subscriptions.refused.removeOne(filter);
    if (m_subscriptions.wanted.removeOne(filter) && isConnected()) {
        m_session->unsubscribe(filter);
    }
}

bool BrokerClient::publish(const Message& message)
{
    return isConnected() && m_session->publish(message);
}

void BrokerClient::service()
{
    if (m_nextAttempt && m_clock.now() >= *m_nextAttempt) {
        attempt();
    } else if (m_session != nullptr) {
        m_session->service();
        askAgain();
    }
}

void BrokerClient::attempt()
{
    m_nextAttempt.reset();
    Q_EMIT nextAttemptChanged();
    if (const auto tls = prepareTls()) {
        lookUp();
    } else {
        giveUp({.kind = EndKind::Local, .detail = tls.error().text});
    }
}

// The context is kept while it works. After a failure the files are read again, because somebody may have corrected
// them.
Result<> BrokerClient::prepareTls()
{
    if (m_broker.encryption != Encryption::Tls || m_tls) {
        return {};
    }
    auto context = TlsContext::create(m_broker.caFile, m_broker.host);
    return std::move(context).map([this](auto&& tls) { m_tls = std::forward<decltype(tls)>(tls); });
}

void BrokerClient::lookUp()
{
    if (const QHostAddress address(m_broker.host); !address.isNull()) {
        m_addresses = {address};
        tryNextAddress();
    } else {
        // The slot is passed by name: with a slot passed by address, Qt loses its helper object when a lookup is
        // aborted.
        m_lookup = QHostInfo::lookupHost(m_broker.host, this, SLOT(takeLookup(QHostInfo)));
    }
}

void BrokerClient::takeLookup(const QHostInfo& found)
{
    if (found.lookupId() != m_lookup) {
        return;  // closed in the meantime
    }
    m_lookup = -1;
    m_addresses = found.addresses();
    if (m_addresses.isEmpty()) {
        giveUp({.kind = EndKind::NameUnknown, .detail = found.errorString()});
    } else {
        tryNextAddress();
    }
}

void BrokerClient::tryNextAddress()
{
    m_session = new BrokerSession(m_broker, m_tls, m_will, m_clock, this);
    connect(m_session, &BrokerSession::accepted, this, &BrokerClient::accepted);
    connect(m_session, &BrokerSession::received, this, &BrokerClient::messageReceived);
    connect(m_session, &BrokerSession::dropped, this, &BrokerClient::messageDropped);
    connect(m_session, &BrokerSession::subscriptionAnswered, this, &BrokerClient::takeAnswer);
    connect(m_session, &BrokerSession::ended, this, &BrokerClient::ended);
    m_session->open(m_addresses.takeFirst());
}

void BrokerClient::accepted()
{
    for (const QString& filter : std::as_const(m_subscriptions.wanted)) {
        m_session->subscribe(filter);
    }
    setProblem({});
    m_connectedAt =
        m_clock.now();  // set after the problem was reported, so that its receiver does not see a connection too early
    Q_EMIT connected();
}

void BrokerClient::takeAnswer(const QString& filter, bool granted)
{
    if (granted) {
        if (m_subscriptions.refused.removeOne(filter)) {
            Q_EMIT subscriptionGranted(filter);
        }
    } else if (m_subscriptions.wanted.contains(filter) && !m_subscriptions.refused.contains(filter)) {
        m_subscriptions.refused.append(filter);
        m_subscriptions.askAgainAt = m_clock.now() + kAskAgain;
        Q_EMIT subscriptionRefused(filter);
    }
}

void BrokerClient::askAgain()
{
    if (isConnected() && !m_subscriptions.refused.isEmpty() && m_clock.now() >= m_subscriptions.askAgainAt) {
        m_subscriptions.askAgainAt = m_clock.now() + kAskAgain;
        for (const QString& filter : std::as_const(m_subscriptions.refused)) {
            m_session->subscribe(filter);
        }
    }
}

void BrokerClient::ended(const Ending& ending)
{
    const bool tryOthers = isOfTheAddress(ending.kind) && !m_addresses.isEmpty();
    const auto others = std::exchange(m_addresses, {});
    const bool wasGood = m_connectedAt && m_clock.now() - *m_connectedAt >= kStable;
    if (wasGood) {
        m_delay.reset();
    }
    dropAttempt();
    if (tryOthers) {
        m_addresses = others;
        tryNextAddress();
    } else {
        const bool isOusted = ending.kind == EndKind::Lost && !wasGood && !m_broker.clientId.isEmpty();
        giveUp(isOusted ? Ending{.kind = EndKind::Ousted} : ending);
    }
}

void BrokerClient::giveUp(const Ending& ending)
{
    if (ending.kind == EndKind::CertificateWrong) {
        m_tls.reset();
    }
    m_nextAttempt = m_clock.now() + m_delay.next();
    setProblem(toText(ending, m_broker));
    Q_EMIT nextAttemptChanged();
}

// This may run inside a signal of the session, so the session is deleted later.
void BrokerClient::dropAttempt()
{
    if (m_lookup >= 0) {
        QHostInfo::abortHostLookup(std::exchange(m_lookup, -1));
    }
    m_addresses.clear();
    m_subscriptions.refused.clear();
    m_connectedAt.reset();
    if (BrokerSession* const session = std::exchange(m_session, nullptr)) {
        session->drop();
        session->disconnect(this);
        session->deleteLater();
    }
}

void BrokerClient::setProblem(const QString& problem)
{
    if (m_problem != problem) {
        m_problem = problem;
        Q_EMIT problemChanged(problem);
    }
}

}  // namespace boresight::mqtt

#include "moc_broker_client.cpp"
