// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clients/station_server.h"

#include "core/alarms/catalogue.h"
#include "core/base/control_characters.h"
#include "core/base/peer_address.h"
#include "core/base/text.h"
#include "core/rotctld/error_cycles.h"
#include "core/rotctld/session.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace boresight {
namespace {

rotctld::ServerSettings serverSettings(const profile::RotctldSettings& settings)
{
    return {.host = settings.listen.host,
            .port = settings.listen.port,
            .maxClients = static_cast<std::size_t>(settings.maxClients),
            .allow = settings.allow};
}

rotctld::DumpStateForm formOf(profile::DumpState form)
{
    return form == profile::DumpState::AsHamlib ? rotctld::DumpStateForm::AsHamlib : rotctld::DumpStateForm::OldAndNew;
}

// One or two errors may be chance, and the third leaves time to act before Gpredict gives up.
constexpr int kErrorsForAdvice = 3;

QString remedyOf(const Error& error, const profile::RotctldSettings& settings)
{
    return error.code == ErrorCode::OutOfRange && settings.outsideLimits == profile::OutsideLimits::Refuse
               ? Text::tr("Set rotctld.outside_limits to \"nearest\".")
               : Text::tr("Reason: %1").arg(boresight::printable(error.text));
}

QString advice(const rotctld::ClientInfo& client, const profile::RotctldSettings& settings)
{
    if (!QString::fromStdString(client.program).startsWith(QLatin1String("Gpredict"))) {
        return {};
    }
    if (client.errorsInARow >= kErrorsForAdvice && client.error) {
        return Text::tr("%1 errors in a row. Gpredict disengages after %2. %3")
            .arg(QString::number(client.errorsInARow), QString::number(rotctld::ErrorCycles::kGiveUp),
                 remedyOf(*client.error, settings));
    }
    if (!client.leap) {
        return {};
    }
    return Text::tr("This Gpredict updates only every %1°. Set Threshold to 0.1 in its Antenna Control.")
        .arg(client.leap->degrees(), 0, 'f', 0);
}

}  // namespace

StationServer::StationServer(StationControl& control, const profile::InForce& profile, EventLog& log,
                             const Clock& clock, QObject* parent)
    : m_control(control),
      m_profile(profile),
      m_log(log),
      m_rotator(control, profile, log, clock),
      m_protocolLog(clock),
      m_logged(m_rotator, m_protocolLog),
      m_server(serverSettings(profile->rotctld),
               rotctld::talkRotctld(m_logged, clock, formOf(profile->rotctld.dumpState)), m_logged, clock, parent),
      m_further(control, profile, log, m_logged, clock, m_server.newestClient(), parent)
{}

Result<> StationServer::open()
{
    const Result<> listening = m_server.listen();
    if (listening) {
        m_log.add(Severity::Advisory, QStringLiteral("rotctld"), Text::tr("listening on %1").arg(address()));
        tellOpenPort();
    } else {
        m_control.alarms().raise(alarmEntry("rotctld.not-listening"), {listening.error().text});
    }
    m_further.open();
    return listening;
}

void StationServer::close()
{
    m_server.close();
    m_further.close();
}

// The protocol has no password: everybody who reaches the port can move the mount.
void StationServer::tellOpenPort()
{
    const profile::RotctldSettings& settings = m_profile->rotctld;
    if (isThisComputer(settings.listen.host) || !settings.allow.empty() || m_server.address().empty()) {
        m_control.alarms().clear(alarmEntry("rotctld.open"));
        return;
    }
    m_control.alarms().raise(alarmEntry("rotctld.open"), {address()});
}

// The server does not know the profile, so it gets the settings here.
void StationServer::profileChanged()
{
    const rotctld::ServerSettings settings = serverSettings(m_profile->rotctld);
    m_server.setAllowed(settings.allow);
    m_server.setMaxClients(settings.maxClients);
    m_further.profileChanged();
    tellOpenPort();
}

Result<> StationServer::disconnect(std::uint64_t client, const QString& reason)
{
    return m_server.disconnect(client, reason) || m_further.disconnect(client, reason)
               ? Result<>{}
               : failure(ErrorCode::NotAvailable, Text::tr("this client has disconnected"));
}

QString StationServer::address() const
{
    return toQString(m_server.address());
}

std::vector<ClientStatus> StationServer::clients(std::vector<rotctld::ClientInfo> others) const
{
    std::vector<ClientStatus> list;
    std::vector<rotctld::ClientInfo> all = m_server.clients();
    std::ranges::move(m_further.clients(), std::back_inserter(all));
    std::ranges::move(others, std::back_inserter(all));
    for (const rotctld::ClientInfo& client : all) {
        ClientStatus status{.id = client.id,
                            .address = QString::fromStdString(client.address),
                            .program = QString::fromStdString(client.program),
                            .lastCommand = client.lastCommand,
                            .commandsPerSecond = client.commandsPerSecond,
                            .oddCommands = client.oddCommands,
                            .advice = advice(client, m_profile->rotctld)};
        m_control.describe(status, client.lastMotion);
        list.push_back(std::move(status));
    }
    return list;
}

}  // namespace boresight
