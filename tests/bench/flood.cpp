// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/flood.h"

#include <sys/epoll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string_view>
#include <vector>

namespace boresight::bench {
namespace {

using SteadyClock = std::chrono::steady_clock;

constexpr std::size_t kBlock = 4096;  // bytes offered to the kernel at once

struct Flooder
{
    int fd = -1;
    std::size_t position = 0;  // in the round of commands
};

bool comeIn(Flooder& flooder, std::uint64_t number, const Endpoint& endpoint, int epoll)
{
    flooder = {.fd = openSocket(0), .position = 0};
    epoll_event event{.events = EPOLLIN | EPOLLOUT, .data = {.u64 = number}};
    return connectTo(flooder.fd, endpoint) && epoll_ctl(epoll, EPOLL_CTL_ADD, flooder.fd, &event) == 0;
}

// Returns false when the connection is closed.
bool readAnswers(int fd, std::uint64_t& lines)
{
    std::array<char, 65536> buffer;
    const ssize_t count = recv(fd, buffer.data(), buffer.size(), MSG_DONTWAIT);
    if (count > 0) {
        lines += static_cast<std::uint64_t>(std::count(buffer.data(), buffer.data() + count, '\n'));
    }
    return count > 0 || (count < 0 && errno == EAGAIN);
}

bool sendCommands(Flooder& flooder, std::string_view commands, std::size_t round)
{
    const ssize_t count = send(flooder.fd, commands.data() + flooder.position, kBlock, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count > 0) {
        flooder.position = (flooder.position + static_cast<std::size_t>(count)) % round;
    }
    return count > 0 || errno == EAGAIN;
}

}  // namespace

FloodOutcome flood(const Endpoint& endpoint, std::size_t clients, const std::string& commands,
                   std::chrono::milliseconds duration)
{
    FloodOutcome outcome;
    const auto end = SteadyClock::now() + duration;
    std::string block = commands;  // long enough that kBlock bytes follow any position in the round
    while (block.size() < commands.size() + kBlock) {
        block += commands;
    }
    const int epoll = epoll_create1(EPOLL_CLOEXEC);
    std::vector<Flooder> flooders(clients);
    bool listening = true;
    for (std::size_t i = 0; i < clients; ++i) {
        listening = comeIn(flooders[i], i, endpoint, epoll) && listening;
    }
    while (listening && SteadyClock::now() < end) {
        std::array<epoll_event, 64> events{};
        const int ready = epoll_wait(epoll, events.data(), int(events.size()), 10);
        for (int i = 0; i < ready; ++i) {
            const epoll_event& event = events[static_cast<std::size_t>(i)];
            Flooder& flooder = flooders[event.data.u64];
            const bool alive = ((event.events & ~EPOLLOUT) == 0 || readAnswers(flooder.fd, outcome.lines)) &&
                               ((event.events & EPOLLOUT) == 0 || sendCommands(flooder, block, commands.size()));
            if (!alive) {
                ++outcome.dropped;
                close(flooder.fd);
                listening = comeIn(flooder, event.data.u64, endpoint, epoll) && listening;
            }
        }
    }
    for (const Flooder& flooder : flooders) {
        close(flooder.fd);
    }
    close(epoll);
    return outcome;
}

}  // namespace boresight::bench
