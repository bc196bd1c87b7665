// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mqtt/broker.h"

#include <QString>

// Why there is no connection, or none any more, and the line about it for the operator: what, where, what to do. Pure.
namespace boresight::mqtt {

enum class EndKind
{
    NameUnknown,       // of the host
    ConnectionFailed,  // refused, no route: what the system says
    NoAnswer,          // not even that
    Silent,            // somebody took the connection and says nothing
    HungUp,            // and closed it before saying anything
    TlsRefused,        // no encryption that both accept
    CertificateWrong,
    ProtocolRefused,
    ClientIdRefused,
    NotServing,
    LoginRefused,
    Lost,      // it worked before
    Ousted,    // the same, soon after it had begun
    NoPulse,   // it worked before, and nothing arrived since
    Nonsense,  // what comes is not MQTT
    Local      // nothing to do with the broker: memory, a CA file that cannot be read
};

struct Ending
{
    EndKind kind = EndKind::Lost;
    QString detail;  // what the system or the library says; may be empty

    bool operator==(const Ending&) const = default;
};

// The next address of the same host may be better.
[[nodiscard]] bool isOfTheAddress(EndKind kind);

[[nodiscard]] QString toText(const Broker& broker);  // "broker.example:1883"
[[nodiscard]] QString toText(const Ending& ending, const Broker& broker);

}  // namespace boresight::mqtt
