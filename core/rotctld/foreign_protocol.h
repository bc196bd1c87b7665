// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

// Other protocols that reach the port: web browsers, TLS and port scanners, terminals, and programs for another rotator
// protocol. They are detected from the first bytes of a line. The connection is then closed without an answer, before a
// later byte can be read as a command. No line of a known rotctld client matches.
namespace boresight::rotctld {

// The protocol of the line, e.g. "HTTP". Empty if none. `line` may be cut off anywhere.
[[nodiscard]] std::optional<std::string_view> foreignProtocolIn(std::string_view line);

}  // namespace boresight::rotctld
