// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/program_lock.h"
#include "core/rotctld/sockets.h"

#include <cstdint>
#include <memory>
#include <string>

// Where the clients of a server come in: a TCP port, a socket in the file system, or a pseudo-terminal for programs
// that know serial ports only.
namespace boresight::rotctld {

class Entrance
{
public:
    virtual ~Entrance() = default;

    [[nodiscard]] virtual std::string address() const = 0;
    [[nodiscard]] virtual std::uint16_t port() const { return 0; }  // of TCP
    [[nodiscard]] virtual tl::expected<Accepted, AcceptFailure> accept() = 0;
    // A client has left, by itself, or because the server hung up on it or did not want it.
    virtual void left(bool /*byItself*/) {}
    // Lets `epoll` report a client that waits, under this number, or no longer. False: that changes nothing.
    virtual bool watch(const Descriptor& /*epoll*/, std::uint64_t /*number*/, bool /*on*/) { return false; }
    // Else the server has to ask from time to time.
    [[nodiscard]] virtual bool isWatched() const { return false; }
};

[[nodiscard]] Result<std::unique_ptr<Entrance>> openTcp(const std::string& host, std::uint16_t port);
// Makes a pseudo-terminal and a link to it at `path`, which stays the same while the terminal behind it may change. One
// client at a time. Busy: another program serves this path, or it is no link.
[[nodiscard]] Result<std::unique_ptr<Entrance>> openTerminal(const std::string& path);
// Makes a socket at `path` that only programs of this user open. That of a program that was killed is replaced. Busy:
// another program serves this path, or it is no socket.
[[nodiscard]] Result<std::unique_ptr<Entrance>> openUnix(const std::string& path);

// Keeps a path from other programs that serve one, by a file beside it. The text of an error is why.
[[nodiscard]] Result<ProgramLock> lockPlace(const std::string& path);
// What watch() of an entrance with a listening socket does. False: that changes nothing.
bool watchListener(const Descriptor& epoll, const Descriptor& listener, std::uint64_t number, bool was, bool on);

}  // namespace boresight::rotctld
