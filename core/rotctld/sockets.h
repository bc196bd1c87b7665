// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

// The non-blocking system calls of the server, each with a reason for a failure. Linux. Receiving and sending also work
// on a pseudo-terminal.
namespace boresight::rotctld {

// Owns a file descriptor.
class Descriptor
{
public:
    Descriptor() = default;
    explicit Descriptor(int fd) : m_fd(fd) {}
    Descriptor(Descriptor&& other) noexcept : m_fd(std::exchange(other.m_fd, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept
    {
        std::swap(m_fd, other.m_fd);
        return *this;
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor();

    [[nodiscard]] int get() const { return m_fd; }
    [[nodiscard]] bool valid() const { return m_fd >= 0; }

private:
    int m_fd = -1;
};

struct Accepted
{
    Descriptor socket;
    std::string address;  // "127.0.0.1:51234", "[::1]:51234"
};

// `host` is an address or "localhost". Names are not looked up, because that could block.
[[nodiscard]] Result<Descriptor> listenOn(const std::string& host, std::uint16_t port);
[[nodiscard]] std::string localAddress(const Descriptor& socket);
[[nodiscard]] std::uint16_t localPort(const Descriptor& socket);

enum class AcceptFailure
{
    NoneWaiting,
    Shortage  // no memory, or only the reserved descriptors are left; the client waits in the queue of the kernel
};

[[nodiscard]] tl::expected<Accepted, AcceptFailure> acceptOne(const Descriptor& listener);

struct Received
{
    std::string_view bytes;
    bool atEnd = false;  // the peer sends no more
    QString failure;     // why the connection broke, else empty
};

[[nodiscard]] Received receiveSome(const Descriptor& socket, char* buffer, std::size_t size);
// The number of bytes that were sent. Empty if the connection broke.
[[nodiscard]] std::optional<std::size_t> sendSome(const Descriptor& socket, std::string_view bytes);
void endSending(const Descriptor& socket);

}  // namespace boresight::rotctld
