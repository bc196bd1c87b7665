// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/client_server.h"

#include "core/base/text.h"

namespace boresight::rotctld {

ClientInfo infoOf(const Client& client, const ClientHabits& habits, SteadyTime now)
{
    return {.id = client.id,
            .address = client.address,
            .program = client.protocol == "rotctld" ? std::string(habits.program()) : client.protocol,
            .lastCommand = habits.lastInWords(),
            .oddCommands = habits.oddCommands(),
            .commandsPerSecond = habits.commandsPerSecond(now),
            .lastMotion = habits.lastMotion(),
            .leap = habits.leap(),
            .errorsInARow = habits.errors().inARow(),
            .error = habits.errors().error()};
}

Client newClient(const ServerSettings& settings, const std::string& address)
{
    return {.id = ++*settings.newestClient,
            .address = address,
            .protocol = settings.protocol,
            .readsOnly = settings.readsOnly};
}

bool isTurnedAway(const Client& client, const ServerSettings& settings, Admission& admission, Rotator& rotator)
{
    const std::string host = hostOf(client.address);
    if (!admission.admits(host)) {
        // Logged without its port, so that repeated attempts of a host make one line in the log.
        rotator.clientRemark(
            {.address = host, .protocol = settings.protocol},
            Text::tr("refused: its address is not permitted (%1)").arg(QLatin1String(settings.allowKey)));
        return true;
    }
    const QString crowd = admission.crowd(host, settings.maxClients);
    if (!crowd.isEmpty() && admission.isCrowdNews()) {
        rotator.clientRemark(client, crowd);
    }
    return !crowd.isEmpty();
}

}  // namespace boresight::rotctld
