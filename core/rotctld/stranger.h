// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

// Other protocols that knock at the port: web browsers, TLS and port scanners, terminals, and programs set up for
// another rotator protocol. Told from the first bytes of a line; the connection is then closed without an answer,
// before any later byte of it can be taken for a command. No line of a known rotctld client is matched.
namespace boresight::rotctld {

// What the line is, e.g. "HTTP", or nothing. `line` may be cut off anywhere.
[[nodiscard]] std::optional<std::string_view> strangerIn(std::string_view line);

}  // namespace boresight::rotctld
