// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/udp_server/rotor_command.h"

#include <string>
#include <string_view>

// The datagrams of N1MM Logger+ and similar programs to a program for rotors: bytes -> values. No answers. Pure.
namespace boresight::udp {

// One datagram. `rotor`: the name of the rotor; empty: every rotor. A stop counts in any datagram that is not for
// another rotor. Errors: InvalidInput: no command. OutOfRange: an azimuth that no mount has. NotAvailable: a turn with
// an offset.
[[nodiscard]] Result<Command> parseN1mm(std::string_view datagram, const std::string& rotor);

}  // namespace boresight::udp
