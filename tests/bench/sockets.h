// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <string_view>

// The client's end of TCP for the benchmarks: plain descriptors, which the caller closes. Loopback only.
namespace boresight::bench {

struct Endpoint
{
    std::uint32_t address = 0;  // IPv4, network byte order
    std::uint16_t port = 0;     // host byte order
};

// "127.0.0.1:4533". Refuses addresses outside 127.0.0.0/8, because the scenarios would be a flood for another computer.
[[nodiscard]] Result<Endpoint> parseEndpoint(std::string_view text);

// A socket without Nagle's delay. Its blocking reads give up after 5 s. `flags` as for socket(2), e.g. SOCK_NONBLOCK.
[[nodiscard]] int openSocket(int flags);

// Also true while a non-blocking connect is in progress.
bool connectTo(int fd, const Endpoint& endpoint);

}  // namespace boresight::bench
