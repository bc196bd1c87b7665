// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// A listener for client programs besides the rotctld server, as one line of the profile: protocol, rights, place, and
// who may connect: "gs232b drive tcp:0.0.0.0:4534 192.168.1.0/24", "gs232a read pty:/run/user/1000/rotator". Pure.
namespace boresight::listeners {

enum class Protocol
{
    Gs232A,
    Gs232B,
    Easycomm1,
    Easycomm2,
    Easycomm3,
    Pairs
};

enum class Rights
{
    Drive,
    Read  // reads the position and stops the mount, no more
};

struct Listener
{
    Protocol protocol = Protocol::Gs232A;
    Rights rights = Rights::Drive;
    std::string pty;                      // path of the link to a pseudo-terminal; empty: there is none
    std::string unixPath = {};            // of a socket in the file system; both empty: TCP
    std::string host;                     // of TCP: an address or "localhost"
    std::uint16_t port = 0;               // of TCP; 0 takes any free port
    std::vector<std::string> allow = {};  // of TCP: addresses and networks; empty: whoever can reach the port

    bool operator==(const Listener&) const = default;
};

// InvalidInput: what is wrong with which word.
[[nodiscard]] Result<Listener> parseListener(std::string_view text);
// For people, the same in all languages: "GS-232B".
[[nodiscard]] std::string_view nameOf(Protocol protocol);
// Where it is to listen: "0.0.0.0:4534", "[::1]:4534", "/run/user/1000/rotator".
[[nodiscard]] std::string placeOf(const Listener& listener);
// Whoever reaches it moves the mount, and it is reached from other computers.
[[nodiscard]] bool isOpenToAll(const Listener& listener);
// Two that cannot both be opened: the same port or the same path. A port of 0 is never the same.
[[nodiscard]] bool collide(const Listener& one, const Listener& other);

}  // namespace boresight::listeners
