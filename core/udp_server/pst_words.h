// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/udp_server/rotor_command.h"

#include <string>
#include <string_view>

// The UDP control of PstRotator: datagrams and answers, bytes <-> values. Pure.
namespace boresight::udp {

// One datagram, in upper or lower case. A stop counts in any datagram. Otherwise the whole datagram is one command.
// Errors: InvalidInput: no command, or two motions. OutOfRange: an angle that no mount has.
[[nodiscard]] Result<Command> parsePst(std::string_view datagram);

// "AZ:123.4\r", in tenths of a degree.
[[nodiscard]] std::string pstAnswer(Ask question, const SkyPointing& place);

}  // namespace boresight::udp
