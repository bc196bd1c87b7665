// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fakes/tcp_peer.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

namespace boresight::fakes {
namespace {

using SteadyClock = std::chrono::steady_clock;

constexpr int kLooks = 200;  // a computer that was busy during the whole patience has looked only once

}  // namespace

TcpPeer::TcpPeer(const std::string& host, std::uint16_t port, Pump pump) : m_pump(std::move(pump))
{
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    ::inet_pton(AF_INET, host.c_str(), &address.sin_addr);
    // Connecting may block: the kernel completes it from the backlog without the server.
    m_fd = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    // A fixed buffer: otherwise the kernel enlarges it to some megabytes, as much as the machine permits.
    const int room = 131'072;
    ::setsockopt(m_fd, SOL_SOCKET, SO_RCVBUF, &room, sizeof room);
    const void* const untyped = &address;
    if (::connect(m_fd, static_cast<const sockaddr*>(untyped), sizeof address) != 0) {
        ::close(std::exchange(m_fd, -1));
        return;
    }
    const int on = 1;
    ::setsockopt(m_fd, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    m_pump();
}

TcpPeer::~TcpPeer()
{
    if (m_fd >= 0) {
        ::close(m_fd);
    }
}

bool TcpPeer::send(std::string_view bytes, std::chrono::milliseconds patience)
{
    auto lastProgress = SteadyClock::now();
    while (!bytes.empty()) {
        const ssize_t sent = ::send(m_fd, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        if (sent > 0) {
            bytes.remove_prefix(static_cast<std::size_t>(sent));
            lastProgress = SteadyClock::now();
        } else if (errno != EAGAIN || SteadyClock::now() - lastProgress > patience) {
            return false;
        }
        m_pump();
    }
    return true;
}

void TcpPeer::endSending()
{
    ::shutdown(m_fd, SHUT_WR);
}

void TcpPeer::reset()
{
    const linger now{.l_onoff = 1, .l_linger = 0};
    ::setsockopt(m_fd, SOL_SOCKET, SO_LINGER, &now, sizeof now);
    ::close(std::exchange(m_fd, -1));
}

bool TcpPeer::readSome(std::string& into)
{
    std::array<char, 65536> buffer;
    const ssize_t count = ::recv(m_fd, buffer.data(), buffer.size(), MSG_DONTWAIT);
    if (count > 0) {
        into.append(buffer.data(), static_cast<std::size_t>(count));
        m_segments.push_back(static_cast<std::size_t>(count));
        return true;
    }
    m_closed = m_closed || count == 0 || errno != EAGAIN;
    return false;
}

std::string TcpPeer::receive(const Enough& enough, std::chrono::milliseconds quiet, std::chrono::milliseconds patience)
{
    std::string bytes;
    const auto begin = SteadyClock::now();
    auto last = begin;
    for (int looks = 1; !m_closed; ++looks) {
        m_pump();
        const auto now = SteadyClock::now();
        last = readSome(bytes) ? now : last;
        if (enough(bytes) ? now - last >= quiet : looks >= kLooks && now - begin > patience) {
            break;
        }
    }
    return bytes;
}

std::string TcpPeer::receiveLines(int count)
{
    return receive([count](const std::string& bytes) { return std::ranges::count(bytes, '\n') >= count; },
                   std::chrono::milliseconds(0), std::chrono::seconds(30));
}

std::string TcpPeer::ask(std::string_view command, int lines)
{
    send(command);
    const auto isWhole = [lines](const std::string& reply) {
        return reply.starts_with("RPRT -") ? reply.ends_with('\n') : std::ranges::count(reply, '\n') >= lines;
    };
    return receive(isWhole, std::chrono::milliseconds(0), std::chrono::seconds(30));
}

std::string TcpPeer::receiveUntilClosed(std::chrono::milliseconds patience)
{
    std::string bytes;
    const auto begin = SteadyClock::now();
    while (!m_closed && SteadyClock::now() - begin < patience) {
        m_pump();
        readSome(bytes);
    }
    return bytes;
}

bool TcpPeer::closedByServer()
{
    std::string ignored;
    for (int i = 0; i < 20 && !m_closed; ++i) {
        m_pump();
        readSome(ignored);
    }
    return m_closed;
}

}  // namespace boresight::fakes
