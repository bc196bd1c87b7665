// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clients/station_listeners.h"

#include "core/alarms/catalogue.h"
#include "core/base/overloaded.h"
#include "core/base/text.h"
#include "core/easycomm_server/easycomm_controller.h"
#include "core/gs232_server/emulated_box.h"
#include "core/pairs_server/pairs_talk.h"
#include "core/rotctld/server.h"
#include "core/udp_server/datagram_server.h"
#include "core/udp_server/n1mm_words.h"
#include "core/udp_server/pst_words.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <variant>

namespace boresight {
namespace {

using listeners::Listener;
using listeners::Protocol;

rotctld::ServerSettings serverSettings(const Listener& listener, const std::shared_ptr<std::uint64_t>& newestClient,
                                       std::size_t maxClients)
{
    return {.host = listener.host,
            .port = listener.port,
            .maxClients = maxClients,
            .allow = listener.allow,
            .pty = listener.pty,
            .unixPath = listener.unixPath,
            .protocol = std::string(listeners::nameOf(listener.protocol)),
            .allowKey = "listeners.list",
            .readsOnly = listener.rights == listeners::Rights::Read,
            .newestClient = newestClient};
}

// With connections, or with datagrams.
using Language = std::variant<rotctld::StartConversation, udp::Parse>;

// A new protocol needs a line here.
Language languageOf(const Listener& listener, rotctld::Rotator& rotator, const Clock& clock,
                    const profile::InForce& profile)
{
    switch (listener.protocol) {
        case Protocol::Gs232A:
            return gs232::talkGs232(rotator, clock, gs232::Dialect::A);
        case Protocol::Gs232B:
            return gs232::talkGs232(rotator, clock, gs232::Dialect::B);
        case Protocol::Easycomm1:
            return easycomm::talkEasycomm(rotator, clock, easycomm::Version::One);
        case Protocol::Easycomm2:
            return easycomm::talkEasycomm(rotator, clock, easycomm::Version::Two);
        case Protocol::Easycomm3:
            return easycomm::talkEasycomm(rotator, clock, easycomm::Version::Three);
        case Protocol::Pairs:
            return pairs::talkPairs(rotator, clock, [&profile] {
                return profile->site.known ? std::optional(profile->site.place()) : std::nullopt;
            });
        case Protocol::Pst:
            return udp::Parse(udp::parsePst);
        case Protocol::N1mm:
            break;
    }
    return udp::Parse([rotor = listener.rotor](std::string_view datagram) { return udp::parseN1mm(datagram, rotor); });
}

}  // namespace

StationListeners::StationListeners(StationControl& control, const profile::InForce& profile, EventLog& log,
                                   rotctld::Rotator& rotator, const Clock& clock,
                                   std::shared_ptr<std::uint64_t> newestClient, QObject* parent)
    : m_control(control),
      m_profile(profile),
      m_log(log),
      m_rotator(rotator),
      m_clock(clock),
      m_newestClient(std::move(newestClient)),
      m_parent(parent)
{}

void StationListeners::open()
{
    QStringList failed;
    QStringList exposed;
    QStringList forgeable;
    for (const std::string& line : m_profile->listeners) {
        const auto listener = listeners::parseListener(line);
        if (!listener) {
            continue;  // cannot happen: a profile with such a line is refused
        }
        auto server = serverOf(*listener);
        if (const Result<> listening = server->listen(); !listening) {
            failed << listening.error().text;
            continue;
        }
        const QString address = toQString(server->address());
        m_log.add(Severity::Advisory, QStringLiteral("listeners"),
                  Text::tr("%1 listens on %2").arg(toQString(listeners::nameOf(listener->protocol)), address));
        if (listeners::isOpenToAll(*listener)) {
            exposed << address;
        }
        if (listeners::isOpenToForgery(*listener)) {
            forgeable << address;
        }
        m_servers.push_back(std::move(server));
    }
    if (!failed.isEmpty()) {
        m_control.alarms().raise(alarmEntry("listener.not-open"), {failed.join(QStringLiteral("; "))});
    }
    if (!exposed.isEmpty()) {
        m_control.alarms().raise(alarmEntry("listener.open"), {exposed.join(QStringLiteral(", "))});
    }
    if (!forgeable.isEmpty()) {
        m_control.alarms().raise(alarmEntry("listener.datagrams"), {forgeable.join(QStringLiteral(", "))});
    }
}

std::unique_ptr<rotctld::ClientServer> StationListeners::serverOf(const Listener& listener) const
{
    rotctld::ServerSettings settings =
        serverSettings(listener, m_newestClient, static_cast<std::size_t>(m_profile->rotctld.maxClients));
    Language language = languageOf(listener, m_rotator, m_clock, m_profile);
    return std::visit(Overloaded{[&](rotctld::StartConversation& talk) -> std::unique_ptr<rotctld::ClientServer> {
                                     return std::make_unique<rotctld::Server>(std::move(settings), std::move(talk),
                                                                              m_rotator, m_clock, m_parent);
                                 },
                                 [&](udp::Parse& parse) -> std::unique_ptr<rotctld::ClientServer> {
                                     return std::make_unique<udp::DatagramServer>(
                                         std::move(settings), std::move(parse), m_rotator, m_clock,
                                         [this](std::uint64_t client) { return isReadOnly(client); }, m_parent);
                                 }},
                      language);
}

bool StationListeners::isReadOnly(std::uint64_t client) const
{
    ClientStatus status{.id = client};
    m_control.describe(status, {});
    return status.readOnly;
}

void StationListeners::tick()
{
    for (const auto& server : m_servers) {
        server->tick();
    }
}

void StationListeners::profileChanged()
{
    for (const auto& server : m_servers) {
        server->setMaxClients(static_cast<std::size_t>(m_profile->rotctld.maxClients));
    }
}

bool StationListeners::disconnect(std::uint64_t client, const QString& reason)
{
    return std::ranges::any_of(m_servers, [&](const auto& server) { return server->disconnect(client, reason); });
}

std::vector<rotctld::ClientInfo> StationListeners::clients() const
{
    std::vector<rotctld::ClientInfo> all;
    for (const auto& server : m_servers) {
        std::ranges::move(server->clients(), std::back_inserter(all));
    }
    return all;
}

std::vector<std::string> StationListeners::addresses() const
{
    std::vector<std::string> all;
    for (const auto& server : m_servers) {
        all.push_back(server->address());
    }
    return all;
}

}  // namespace boresight
