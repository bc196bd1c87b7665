// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mqtt/inlet.h"

#include <linux/tcp.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

namespace boresight::mqtt {
namespace {

constexpr std::size_t kLongestHeader = 5;
constexpr unsigned kBitsOfLength = 7;  // per byte; the eighth bit means that another byte follows

// Makes poll() report "readable" only when this many bytes have arrived.
void wakeAt(int socket, std::size_t bytes)
{
    const int wanted = static_cast<int>(bytes);
    setsockopt(socket, SOL_SOCKET, SO_RCVLOWAT, &wanted, sizeof wanted);
}

// The number of bytes that were read from the socket: arrived bytes minus waiting bytes. Measured again if bytes
// arrived between the two measurements.
std::uint64_t consumed(int socket)
{
    const auto arrived = [socket] {
        tcp_info info{};
        socklen_t size = sizeof info;
        return getsockopt(socket, IPPROTO_TCP, TCP_INFO, &info, &size) == 0 ? std::uint64_t{info.tcpi_bytes_received}
                                                                            : 0;
    };
    std::uint64_t before = 0;
    std::uint64_t after = arrived();
    int waiting = 0;
    do {
        before = after;
        ioctl(socket, FIONREAD, &waiting);
        after = arrived();
    } while (after != before);
    return after - static_cast<std::uint64_t>(waiting);
}

bool isEmptyForNow(ssize_t received)
{
    return received < 0 && (errno == EAGAIN || errno == EINTR);
}

}  // namespace

std::optional<std::size_t> packetLength(std::span<const std::uint8_t> bytes)
{
    std::size_t rest = 0;
    for (std::size_t i = 1; i < kLongestHeader; ++i) {
        if (i >= bytes.size()) {
            return std::nullopt;
        }
        rest |= std::size_t{bytes[i] & 0x7FU} << (kBitsOfLength * (i - 1));
        if ((bytes[i] & 0x80U) == 0) {
            return 1 + i + rest;
        }
    }
    return 0;
}

bool hungUp(int socket)
{
    pollfd request{.fd = socket, .events = POLLRDHUP, .revents = 0};
    return poll(&request, 1, 0) == 1 && (request.revents & (POLLRDHUP | POLLHUP | POLLERR)) != 0;
}

bool Inlet::mayRead(int socket)
{
    if (m_toDrop > 0) {
        return drop(socket);
    }
    if (m_end && consumed(socket) < *m_end) {
        return true;
    }
    m_end.reset();
    std::array<std::uint8_t, kLongestHeader> ahead{};
    const ssize_t received = recv(socket, ahead.data(), ahead.size(), MSG_PEEK | MSG_DONTWAIT);
    if (received <= 0) {
        return !isEmptyForNow(received);
    }
    return judge(socket, std::span(ahead).first(static_cast<std::size_t>(received)));
}

bool Inlet::judge(int socket, std::span<const std::uint8_t> ahead)
{
    const auto length = packetLength(ahead);
    if (length && *length > kLargestPacket) {
        m_toDrop = *length;
        m_dropped = static_cast<qint64>(*length);
        wakeAt(socket, 1);
        return drop(socket);
    }
    if (!length) {
        wakeAt(socket, ahead.size() + 1);
        return hungUp(socket);
    }
    wakeAt(socket, 1);
    m_end = consumed(socket) + *length;
    return true;
}

bool Inlet::drop(int socket)
{
    std::array<char, kDroppedAtOnce> rubbish;
    const ssize_t received = recv(socket, rubbish.data(), std::min(m_toDrop, rubbish.size()), MSG_DONTWAIT);
    if (received <= 0) {
        return !isEmptyForNow(received);
    }
    m_toDrop -= static_cast<std::size_t>(received);
    return false;
}

std::optional<qint64> Inlet::takeDropped()
{
    return std::exchange(m_dropped, std::nullopt);
}

}  // namespace boresight::mqtt
