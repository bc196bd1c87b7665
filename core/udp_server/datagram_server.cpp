// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/udp_server/datagram_server.h"

#include "core/base/peer_address.h"
#include "core/base/text.h"
#include "core/base/trimmed.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace boresight::udp {

DatagramServer::DatagramServer(rotctld::ServerSettings settings, Parse parse, rotctld::Rotator& rotator,
                               const Clock& clock, IsReadOnly isReadOnly, QObject* parent)
    : QObject(parent),
      m_settings(std::move(settings)),
      m_parse(std::move(parse)),
      m_rotator(rotator),
      m_clock(clock),
      m_isReadOnly(std::move(isReadOnly)),
      m_admission(m_settings.allow),
      m_settling(clock),
      m_inlet(kAtOnce, datagrams::DatagramInlet::kWhole, this)
{
    connect(&m_inlet, &datagrams::DatagramInlet::received, this, &DatagramServer::take);
}

DatagramServer::~DatagramServer()
{
    for (auto sender = m_senders.begin(); sender != m_senders.end();) {
        sender = forget(sender, Text::tr("the server was closed"));
    }
}

// The port is not shared: with two programs the kernel would give each datagram to one of them.
Result<> DatagramServer::listen()
{
    const QHostAddress host = listenAddress(m_settings.host);
    if (host.isNull() || !m_inlet.open(host, m_settings.port, false)) {
        return failure(ErrorCode::Io,
                       Text::tr("cannot listen on UDP %1:%2: %3")
                           .arg(toQString(m_settings.host), QString::number(m_settings.port), m_inlet.trouble()));
    }
    return {};
}

std::string DatagramServer::address() const
{
    return m_inlet.port() == 0 ? std::string() : "UDP " + addressText(m_inlet.host(), m_inlet.port());
}

std::vector<rotctld::ClientInfo> DatagramServer::clients() const
{
    std::vector<rotctld::ClientInfo> list;
    list.reserve(m_senders.size());
    for (const auto& [host, sender] : m_senders) {
        list.push_back(infoOf(sender.client, sender.habits, m_clock.now()));
    }
    std::ranges::sort(list, {}, &rotctld::ClientInfo::id);
    return list;
}

void DatagramServer::tick()
{
    m_settling.tick();
    for (auto sender = m_senders.begin(); sender != m_senders.end();) {
        const bool isSilent = m_clock.now() - sender->second.lastDatagram > kSilence;
        sender = isSilent && !isMarked(sender->second)
                     ? forget(sender, Text::tr("was silent for %1 s").arg(QString::number(kSilence.count())))
                     : std::next(sender);
    }
}

// Programs send each command from another port, so the host is the client. A STOP is obeyed even if there is no room
// for another client.
void DatagramServer::take(const QByteArray& bytes, const QHostAddress& host, std::uint16_t port)
{
    m_settling.tick();  // datagrams wait at the port while the computer sleeps or this thread is blocked
    const std::string_view datagram(bytes.constData(), static_cast<std::size_t>(bytes.size()));
    if (trimmed(datagram).empty()) {
        return;
    }
    const std::string address = addressText(host, port);
    const std::string name = hostOf(address);
    if (const auto known = m_senders.find(name); known != m_senders.end()) {
        obey(known->second, datagram, host);
        return;
    }
    const rotctld::Client client = newClient(m_settings, address);
    if (!isTurnedAway(client, m_settings, m_admission, m_rotator)) {
        obey(welcome(client, name), datagram, host);
    } else if (m_admission.admits(name) && stops(m_parse(datagram))) {
        const Result<> stopped = m_rotator.stop(client);
        if (m_rotator.isLoggingExchanges()) {
            m_rotator.logExchange(client, {.line = datagram, .result = stopped});
        }
    }
}

DatagramServer::Sender& DatagramServer::welcome(const rotctld::Client& client, const std::string& host)
{
    m_admission.enter(host);
    m_rotator.clientConnected(client);
    const UdpController::Shared shared{
        .rotator = m_rotator, .parse = m_parse, .settling = m_settling, .clock = m_clock};
    Sender sender{
        .client = client, .controller = UdpController(client, shared), .habits = rotctld::ClientHabits(m_clock.now())};
    return m_senders.emplace(host, std::move(sender)).first->second;
}

void DatagramServer::obey(Sender& sender, std::string_view datagram, const QHostAddress& host)
{
    const SteadyTime now = m_clock.now();
    sender.lastDatagram = now;
    const rotctld::LineOutcome outcome = sender.controller.obey(datagram);
    sender.habits.take(trimmed(datagram).substr(0, rotctld::kShownBytes), outcome, now);
    sender.habits.answered(outcome.result, outcome.became);
    if (isOdd(outcome)) {
        sender.habits.countOdd();
    }
    if (!outcome.reply.empty()) {
        m_inlet.send(QByteArray::fromStdString(outcome.reply), host, static_cast<std::uint16_t>(port() + 1));
    }
    if (m_rotator.isLoggingExchanges()) {
        m_rotator.logExchange(sender.client, {.line = datagram,
                                              .answer = outcome.reply,
                                              .result = outcome.result,
                                              .became = outcome.became,
                                              .odd = isOdd(outcome)});
    }
}

// By the operator. The right "read" of the profile needs no mark: it holds for the next client too.
bool DatagramServer::isMarked(const Sender& sender) const
{
    return !m_settings.readsOnly && m_isReadOnly(sender.client.id);
}

DatagramServer::Senders::iterator DatagramServer::forget(Senders::iterator sender, const QString& reason)
{
    const rotctld::Client client = sender->second.client;
    m_admission.leave(sender->first);
    const auto next = m_senders.erase(sender);
    m_rotator.clientGone(client, reason);
    return next;
}

bool DatagramServer::disconnect(std::uint64_t id, const QString& reason)
{
    const auto found =
        std::ranges::find_if(m_senders, [id](const auto& sender) { return sender.second.client.id == id; });
    if (found == m_senders.end()) {
        return false;
    }
    if (isMarked(found->second)) {
        m_rotator.clientRemark(found->second.client,
                               Text::tr("is not disconnected, because it is read-only. Its next datagram would make it "
                                        "a client that may move the mount."));
    } else {
        forget(found, reason);
    }
    return true;
}

}  // namespace boresight::udp

#include "moc_datagram_server.cpp"
