// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/sockets.h"

#include <chrono>
#include <cstdint>
#include <string>

// Clients that never wait: each sends as fast as its socket accepts data, and discards the replies. One thread.
namespace boresight::bench {

struct FloodOutcome
{
    std::uint64_t lines = 0;    // of replies
    std::uint64_t dropped = 0;  // connections that the server ended; the client reconnects at once
};

// `commands` is repeated all the time. Returns after `duration`, or when nothing listens any more.
[[nodiscard]] FloodOutcome flood(const Endpoint& endpoint, std::size_t clients, const std::string& commands,
                                 std::chrono::milliseconds duration);

}  // namespace boresight::bench
