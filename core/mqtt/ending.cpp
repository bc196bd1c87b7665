// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mqtt/ending.h"

#include "core/base/text.h"

namespace boresight::mqtt {
namespace {

QString withDetail(const QString& text, const Ending& ending)
{
    return text.arg(ending.detail.isEmpty() ? Text::tr("no reason given") : ending.detail);
}

QString loginText(const Broker& broker)
{
    return broker.user.isEmpty()
               ? Text::tr("wants a user name and a password: set mqtt.user and mqtt.password")
               : Text::tr("refuses the user \"%1\" or the password: check mqtt.user and mqtt.password")
                     .arg(broker.user);
}

// Somebody is there, but not what we expect.
QString wrongPortText(const Broker& broker)
{
    return broker.encryption == Encryption::Tls ? Text::tr("is mqtt.port the broker's port for TLS?")
                                                : Text::tr("is mqtt.port right, and does this port want TLS?");
}

QString refusal(const Ending& ending, const Broker& broker)
{
    switch (ending.kind) {
        case EndKind::TlsRefused:
            return withDetail(Text::tr("the encryption could not be agreed on (%1): %2"), ending)
                .arg(wrongPortText(broker));
        case EndKind::CertificateWrong:
            return withDetail(Text::tr("is not trusted: %1"), ending);
        case EndKind::ProtocolRefused:
            return Text::tr("refuses MQTT 3.1.1: a newer broker is needed");
        case EndKind::ClientIdRefused:
            return Text::tr("refuses the client id \"%1\": change mqtt.client_id").arg(broker.clientId);
        case EndKind::NotServing:
            return Text::tr("says that it does not serve at the moment");
        case EndKind::LoginRefused:
            return loginText(broker);
        default:
            return ending.detail;
    }
}

}  // namespace

bool isOfTheAddress(EndKind kind)
{
    return kind == EndKind::ConnectionFailed || kind == EndKind::NoAnswer;
}

QString toText(const Broker& broker)
{
    const bool isIpv6 = broker.host.contains(QLatin1Char(':'));
    return (isIpv6 ? QStringLiteral("[%1]:%2") : QStringLiteral("%1:%2")).arg(broker.host).arg(broker.port);
}

QString toText(const Ending& ending, const Broker& broker)
{
    const auto told = [&]() -> QString {
        switch (ending.kind) {
            case EndKind::NameUnknown:
                return withDetail(Text::tr("the name cannot be resolved (%1): check mqtt.host and the network"),
                                  ending);
            case EndKind::ConnectionFailed:
                return withDetail(Text::tr("no connection (%1): does the broker run there?"), ending);
            case EndKind::NoAnswer:
                return Text::tr("no answer: check mqtt.host, the network and the firewall");
            case EndKind::Silent:
                return Text::tr("takes the connection and says nothing: %1").arg(wrongPortText(broker));
            case EndKind::HungUp:
                return Text::tr("closes the connection before it says anything: %1").arg(wrongPortText(broker));
            case EndKind::Lost:
                return withDetail(Text::tr("the connection is lost (%1)"), ending);
            case EndKind::Ousted:
                return Text::tr(
                           "lets us in and hangs up soon after: was it stopped, or does another program use the "
                           "client id \"%1\"?")
                    .arg(broker.clientId);
            case EndKind::NoPulse:
                return Text::tr("the connection is lost (nothing was heard any more)");
            case EndKind::Nonsense:
                return Text::tr("says something that is not MQTT: %1").arg(wrongPortText(broker));
            default:
                return refusal(ending, broker);
        }
    };
    return Text::tr("MQTT broker %1: %2").arg(toText(broker), told());
}

}  // namespace boresight::mqtt
