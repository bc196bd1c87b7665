// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/program_lock.h"
#include "core/rotctld/sockets.h"

#include <cstdint>
#include <memory>
#include <string>

// Where the clients of a server connect: a TCP port, a socket in the file system, or a pseudo-terminal for programs
// that can use only serial ports.
namespace boresight::rotctld {

class Entrance
{
public:
    virtual ~Entrance() = default;

    [[nodiscard]] virtual std::string address() const = 0;
    [[nodiscard]] virtual std::uint16_t port() const { return 0; }  // of TCP
    [[nodiscard]] virtual tl::expected<Accepted, AcceptFailure> accept() = 0;
    // A client has left: by itself, or because the server dropped or refused it.
    virtual void left(bool /*byItself*/) {}
    // Makes `epoll` report a waiting client with this number, or stops that. False if nothing changed.
    virtual bool watch(const Descriptor& /*epoll*/, std::uint64_t /*number*/, bool /*on*/) { return false; }
    // False: the server must call accept() from time to time.
    [[nodiscard]] virtual bool isWatched() const { return false; }
};

[[nodiscard]] Result<std::unique_ptr<Entrance>> openTcp(const std::string& host, std::uint16_t port);
// Makes a pseudo-terminal and a link to it at `path`. The link stays the same while the terminal behind it may change.
// One client at a time. Busy: another program serves this path, or the path exists and is no link.
[[nodiscard]] Result<std::unique_ptr<Entrance>> openTerminal(const std::string& path);
// Makes a socket at `path` that only programs of this user can open. The socket of a killed program is replaced. Busy:
// another program serves this path, or the path exists and is no socket.
[[nodiscard]] Result<std::unique_ptr<Entrance>> openUnix(const std::string& path);

// Keeps other programs from serving the same path, by a lock file beside it. The text of an error is the reason.
[[nodiscard]] Result<ProgramLock> lockPlace(const std::string& path);
// The implementation of watch() for an entrance with a listening socket. False if nothing changed.
bool watchListener(const Descriptor& epoll, const Descriptor& listener, std::uint64_t number, bool was, bool on);

}  // namespace boresight::rotctld
