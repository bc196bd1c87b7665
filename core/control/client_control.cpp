// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/client_control.h"

#include "core/base/peer_address.h"
#include "core/base/text.h"

#include <algorithm>

namespace boresight {
namespace {

bool lockedOut(const ClientControl::Rules& rules, const std::string& host)
{
    return rules.control == profile::ControlRule::Locked && !sameHost(host, rules.lockedTo);
}

Result<> isUnlocked(const ClientControl::Rules& rules, const std::string& host)
{
    if (lockedOut(rules, host)) {
        return failure(ErrorCode::Refused, Text::tr("The mount is locked to %1.").arg(toQString(rules.lockedTo)));
    }
    return {};
}

QString ago(SteadyTime::duration age)
{
    const auto seconds = std::chrono::floor<std::chrono::seconds>(age).count();
    return seconds < 1 ? Text::tr("a moment ago") : Text::tr("%1 s ago").arg(seconds);
}

}  // namespace

void ClientControl::came(const Source& client, const std::string& host, bool readsOnly)
{
    Connected& one =
        m_clients[client.clientId] = {.client = client, .host = host, .readOnly = readsOnly, .boundToRead = readsOnly};
    if (const auto passer = m_passers.find(host); passer != m_passers.end()) {
        one.asked = passer->second.asked;
        one.waits = passer->second.waits;
        m_passers.erase(passer);
    }
}

// Some programs connect for each command, and would lose control between two commands. So a client that leaves after a
// single motion command leaves the control to a later connection of its host, for kRelease.
void ClientControl::gone(const Source& client)
{
    if (const auto left = m_clients.extract(client.clientId); left && left.mapped().asked && left.mapped().asks <= 1) {
        m_passers[left.mapped().host] = {.asked = *left.mapped().asked, .waits = left.mapped().waits};
    }
    if (!m_active || m_active->client.clientId != client.clientId) {
        return;
    }
    if (m_active->motions == 1 && !m_active->host.empty()) {
        m_active->left = true;
    } else {
        m_active.reset();
    }
}

std::string ClientControl::hostOf(std::uint64_t clientId) const
{
    const auto found = m_clients.find(clientId);
    return found == m_clients.end() ? std::string() : found->second.host;
}

bool ClientControl::hasControl(SteadyTime now) const
{
    return m_active && now - m_active->seen < kRelease;
}

bool ClientControl::controlHeld(const Rules& rules, SteadyTime now) const
{
    return rules.control != profile::ControlRule::Last && hasControl(now) && !lockedOut(rules, m_active->host);
}

bool ClientControl::continues(const Source& client) const
{
    const bool later = client.clientId > m_active->client.clientId;
    return client.clientId == m_active->client.clientId ||
           (m_active->left && later && sameHost(hostOf(client.clientId), m_active->host));
}

QString ClientControl::activeClientText(SteadyTime now) const
{
    const QString when = ago(now - m_active->since);
    if (m_active->left) {
        return Text::tr("%1 has control. It connects for each command. It sent its last command %2.")
            .arg(toQString(m_active->host), when);
    }
    return (m_active->given ? Text::tr("%1 received control %2.")
                            : Text::tr("%1 has control. It sent its last command %2."))
        .arg(m_active->client.name, when);
}

Result<> ClientControl::mayAct(const Rules& rules, const Source& client, SteadyTime now) const
{
    if (readOnly(client.clientId)) {
        return failure(ErrorCode::Refused, Text::tr("The operator has made this client read-only."));
    }
    return isUnlocked(rules, hostOf(client.clientId)).and_then([&]() -> Result<> {
        return controlHeld(rules, now) && !continues(client) ? failure(ErrorCode::Refused, activeClientText(now))
                                                             : Result<>{};
    });
}

Result<> ClientControl::admitsHost(const Rules& rules, const std::string& host, SteadyTime now) const
{
    return isUnlocked(rules, host).and_then([&]() -> Result<> {
        const bool isActiveClient = m_active && m_active->left && sameHost(host, m_active->host);
        return controlHeld(rules, now) && !isActiveClient ? failure(ErrorCode::Refused, activeClientText(now))
                                                          : Result<>{};
    });
}

Result<> ClientControl::admits(const Rules& rules, const Source& client, SteadyTime now) const
{
    return mayAct(rules, client, now).and_then([&]() -> Result<> {
        if (waits(client.clientId)) {
            return failure(ErrorCode::Refused, Text::tr("Another client re-armed the drives while this client kept "
                                                        "sending. Pause this client for %1 s, or send R 1.")
                                                   .arg(kRelease.count()));
        }
        return {};
    });
}

void ClientControl::asked(const Source& client, SteadyTime now)
{
    std::erase_if(m_passers, [now](const auto& passer) { return now - passer.second.asked >= kRelease; });
    const auto found = m_clients.find(client.clientId);
    if (found == m_clients.end()) {
        return;
    }
    Connected& one = found->second;
    one.waits = one.waits && now - *one.asked < kRelease;
    one.asked = now;
    ++one.asks;
}

void ClientControl::rearmed(const Source& client, SteadyTime now)
{
    for (auto& [id, one] : m_clients) {
        one.waits = id != client.clientId && one.asked && now - *one.asked < kRelease;
    }
    for (auto& [host, passer] : m_passers) {
        passer.waits = !sameHost(host, hostOf(client.clientId));
    }
}

bool ClientControl::waits(std::uint64_t clientId) const
{
    const auto found = m_clients.find(clientId);
    return found != m_clients.end() && found->second.waits;
}

void ClientControl::acted(const Source& client)
{
    if (const auto found = m_clients.find(client.clientId); found != m_clients.end()) {
        found->second.waits = false;
    }
}

void ClientControl::moved(const Source& client, SteadyTime now)
{
    const bool same = m_active && m_active->client.clientId == client.clientId;
    const int motions = same ? m_active->motions : 0;
    m_active = ActiveClient{
        .client = client, .host = hostOf(client.clientId), .since = now, .seen = now, .motions = motions + 1};
}

void ClientControl::read(std::uint64_t clientId, SteadyTime now)
{
    if (const auto found = m_clients.find(clientId); found != m_clients.end()) {
        found->second.read = now;
    }
}

QString ClientControl::taken(SteadyTime now)
{
    m_taken = now;
    m_takenFrom = hasControl(now) && !m_active->left ? std::optional(m_active->client.clientId) : std::nullopt;
    return m_takenFrom ? m_active->client.name : QString();
}

bool ClientControl::isWanted(const Rules& rules, SteadyTime now) const
{
    const auto recent = [now](const std::optional<SteadyTime>& when) { return when && now - *when < kRelease; };
    const auto wants = [&](const auto& each) {
        const auto& [id, one] = each;
        const bool may = !one.readOnly && !lockedOut(rules, one.host);
        return may && (recent(one.asked) || (id == m_takenFrom && recent(one.read)));
    };
    const auto comesAgain = [&](const auto& passer) {
        const auto& [host, one] = passer;
        return !lockedOut(rules, host) && recent(one.asked) && one.asked > m_taken;
    };
    return std::ranges::any_of(m_clients, wants) || std::ranges::any_of(m_passers, comesAgain);
}

void ClientControl::followed(std::uint64_t clientId, SteadyTime now)
{
    if (m_active && m_active->client.clientId == clientId && now - m_active->seen < kRelease) {
        m_active->seen = now;
    }
}

Result<> ClientControl::mayBeGiven(const Rules& rules, std::uint64_t clientId) const
{
    const auto found = m_clients.find(clientId);
    if (found == m_clients.end()) {
        return failure(ErrorCode::NotAvailable, Text::tr("this client has disconnected"));
    }
    if (lockedOut(rules, found->second.host)) {
        return failure(ErrorCode::Refused,
                       Text::tr("The mount is locked to %1. Unlock it first.").arg(toQString(rules.lockedTo)));
    }
    return mayMove(found->second);
}

Result<> ClientControl::mayMove(const Connected& one)
{
    return one.boundToRead
               ? failure(
                     ErrorCode::Refused,
                     Text::tr("The listener of this client has the right \"read\" (listeners.list in the profile)."))
               : Result<>{};
}

Result<> ClientControl::give(const Rules& rules, std::uint64_t clientId, SteadyTime now)
{
    return mayBeGiven(rules, clientId).map([&] {
        Connected& one = m_clients.at(clientId);
        one.readOnly = false;
        one.waits = false;
        m_active = ActiveClient{.client = one.client, .host = one.host, .since = now, .seen = now, .given = true};
    });
}

Result<> ClientControl::setReadOnly(std::uint64_t clientId, bool readOnly)
{
    const auto found = m_clients.find(clientId);
    if (found == m_clients.end()) {
        return failure(ErrorCode::NotAvailable, Text::tr("this client has disconnected"));
    }
    if (Result<> may = mayMove(found->second); !readOnly && !may) {
        return may;
    }
    found->second.readOnly = readOnly;
    if (readOnly && m_active && m_active->client.clientId == clientId) {
        m_active.reset();
    }
    return {};
}

void ClientControl::resume(SteadyTime now)
{
    for (auto& [id, one] : m_clients) {
        one.waits = false;
    }
    m_passers.clear();
    if (m_active && !m_active->left) {
        m_active->since = now;
        m_active->seen = now;
    }
}

bool ClientControl::hasControl(const Rules& rules, std::uint64_t clientId, SteadyTime now) const
{
    return controlHeld(rules, now) && !m_active->left && m_active->client.clientId == clientId;
}

bool ClientControl::readOnly(std::uint64_t clientId) const
{
    const auto found = m_clients.find(clientId);
    return found != m_clients.end() && found->second.readOnly;
}

bool ClientControl::locked(const Rules& rules, std::uint64_t clientId) const
{
    return rules.control == profile::ControlRule::Locked && sameHost(hostOf(clientId), rules.lockedTo);
}

QString ClientControl::name(std::uint64_t clientId) const
{
    const auto found = m_clients.find(clientId);
    return found == m_clients.end() ? QString() : found->second.client.name;
}

}  // namespace boresight
