// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mqtt/broker.h"

#include <QString>

// Why there is no connection, and the line about it for the operator: what, where, what to do. Pure.
namespace boresight::mqtt {

enum class EndKind
{
    NameUnknown,       // the host name has no address
    ConnectionFailed,  // refused or no route; the system knows the reason
    NoAnswer,          // the host did not answer at all
    Silent,            // the host accepted the connection and sends nothing
    HungUp,            // the host closed the connection before sending anything
    TlsRefused,        // no encryption that both sides accept
    CertificateWrong,
    ProtocolRefused,
    ClientIdRefused,
    NotServing,
    LoginRefused,
    Lost,      // it worked before
    Ousted,    // it worked before, and was lost soon after it had begun
    NoPulse,   // it worked before, but nothing arrives any more
    Nonsense,  // the received data is not MQTT
    Local      // a local reason: memory, a CA file that cannot be read
};

struct Ending
{
    EndKind kind = EndKind::Lost;
    QString detail;  // the text of the system or the library; may be empty

    bool operator==(const Ending&) const = default;
};

// True if another address of the same host may work.
[[nodiscard]] bool isOfTheAddress(EndKind kind);

[[nodiscard]] QString toText(const Broker& broker);  // "broker.example:1883"
[[nodiscard]] QString toText(const Ending& ending, const Broker& broker);

}  // namespace boresight::mqtt
