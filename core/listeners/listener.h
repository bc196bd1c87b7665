// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// A listener for client programs besides the rotctld server, as one line of the profile: protocol, rights, place, and
// who may connect. "gs232b drive tcp:0.0.0.0:4534 192.168.1.0/24", "gs232a read pty:/run/user/1000/rotator",
// "n1mm drive udp:0.0.0.0:12040 192.168.1.5 rotor=Yagi 20". Pure.
namespace boresight::listeners {

enum class Protocol
{
    Gs232A,
    Gs232B,
    Easycomm1,
    Easycomm2,
    Easycomm3,
    Pairs,
    Pst,
    N1mm
};

enum class Rights
{
    Drive,
    Read  // may only read the position and stop the mount
};

struct Listener
{
    Protocol protocol = Protocol::Gs232A;
    Rights rights = Rights::Drive;
    std::string pty;                      // path of the link to a pseudo-terminal; may be empty
    std::string unixPath = {};            // path of a socket in the file system; TCP or UDP if both are empty
    std::string host;                     // for TCP and UDP: an address or "localhost"
    std::uint16_t port = 0;               // for TCP and UDP; 0: any free port
    std::vector<std::string> allow = {};  // for TCP and UDP: addresses and networks; empty: everybody who reaches it
    bool udp = false;                     // UDP in place of TCP
    std::string rotor = {};               // for N1MM: the name of the rotor; empty: every rotor

    bool operator==(const Listener&) const = default;
};

// Error InvalidInput: which word is wrong, and why.
[[nodiscard]] Result<Listener> parseListener(std::string_view line);
// The name for people, not translated: "GS-232B".
[[nodiscard]] std::string_view nameOf(Protocol protocol);
// The place where it listens: "0.0.0.0:4534", "[::1]:4534", "UDP 127.0.0.1:12000", "/run/user/1000/rotator".
[[nodiscard]] std::string placeOf(const Listener& listener);
// True if other computers reach the listener and every client may move the mount.
[[nodiscard]] bool isOpenToAll(const Listener& listener);
// True if other computers reach the listener with datagrams that may move the mount. A datagram can name any sender.
[[nodiscard]] bool isOpenToForgery(const Listener& listener);
// True if the two cannot both be opened, because they have the same path, or the same port of the same address or of
// all addresses. Port 0 is never the same.
[[nodiscard]] bool collide(const Listener& one, const Listener& other);

}  // namespace boresight::listeners
