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
               ? Text::tr("A user name and a password are required. Set mqtt.user and mqtt.password")
               : Text::tr("The broker refuses the user \"%1\" or the password. Check mqtt.user and mqtt.password")
                     .arg(broker.user);
}

// A server answered, but it is not what we expect.
QString wrongPortText(const Broker& broker)
{
    return broker.encryption == Encryption::Tls ? Text::tr("Is mqtt.port the TLS port of the broker?")
                                                : Text::tr("Is mqtt.port right? Does this port need TLS?");
}

QString refusal(const Ending& ending, const Broker& broker)
{
    switch (ending.kind) {
        case EndKind::TlsRefused:
            return withDetail(Text::tr("The encryption failed (%1). %2"), ending).arg(wrongPortText(broker));
        case EndKind::CertificateWrong:
            return withDetail(Text::tr("Boresight does not trust the broker: %1"), ending);
        case EndKind::ProtocolRefused:
            return Text::tr("The broker refuses MQTT 3.1.1. Use a newer broker");
        case EndKind::ClientIdRefused:
            return Text::tr("The broker refuses the client id \"%1\". Change mqtt.client_id").arg(broker.clientId);
        case EndKind::NotServing:
            return Text::tr("The broker reports that it is not available");
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
                return withDetail(Text::tr("The name cannot be resolved (%1). Check mqtt.host and the network"),
                                  ending);
            case EndKind::ConnectionFailed:
                return withDetail(Text::tr("No connection (%1). Is the broker running there?"), ending);
            case EndKind::NoAnswer:
                return Text::tr("No answer. Check mqtt.host, the network and the firewall");
            case EndKind::Silent:
                return Text::tr("The port accepts the connection but does not answer. %1").arg(wrongPortText(broker));
            case EndKind::HungUp:
                return Text::tr("The port closes the connection before it answers. %1").arg(wrongPortText(broker));
            case EndKind::Lost:
                return withDetail(Text::tr("The connection is lost (%1)"), ending);
            case EndKind::Ousted:
                return Text::tr(
                           "The broker closes the connection soon after the login. Was the broker stopped? Does "
                           "another program use the client id \"%1\"?")
                    .arg(broker.clientId);
            case EndKind::NoPulse:
                return Text::tr("The connection is lost (no more data)");
            case EndKind::Nonsense:
                return Text::tr("The answer is not MQTT. %1").arg(wrongPortText(broker));
            default:
                return refusal(ending, broker);
        }
    };
    return Text::tr("MQTT broker %1: %2").arg(toText(broker), told());
}

}  // namespace boresight::mqtt
