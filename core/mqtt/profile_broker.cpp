// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mqtt/profile_broker.h"

#include "core/base/text.h"

namespace boresight::mqtt {

Broker brokerOf(const profile::BrokerSettings& settings, const QString& ownId)
{
    return {.host = toQString(settings.host),
            .port = static_cast<std::uint16_t>(settings.port),
            .user = toQString(settings.user),
            .password = toQString(settings.password),
            .encryption = settings.tls == profile::Tls::On ? Encryption::Tls : Encryption::None,
            .caFile = toQString(settings.caFile),
            .clientId = settings.clientId.empty() ? ownId : toQString(settings.clientId)};
}

}  // namespace boresight::mqtt
