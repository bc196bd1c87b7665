// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

// The server under test: either one that already runs at HOST:PORT, or a program started here for one scenario and
// ended with it, whose memory and processor time can then be read. Loopback only. One thread.
namespace boresight::bench {

struct Endpoint
{
    std::uint32_t address = 0;  // IPv4, network byte order
    std::uint16_t port = 0;     // host byte order
};

// "127.0.0.1:4533"; refuses addresses outside 127.0.0.0/8, because the scenarios are a flood to anybody else.
[[nodiscard]] Result<Endpoint> parseEndpoint(std::string_view text);

class Server
{
public:
    // TARGET is HOST:PORT or a command line. A "{port}" in the command line becomes a free port; without it the program
    // must print "… listening on HOST:PORT" on its standard output.
    [[nodiscard]] static Result<Server> start(const std::string& target);

    Server(Server&& other) noexcept;
    Server& operator=(Server&&) = delete;
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;
    ~Server();  // SIGTERM, then SIGKILL after 5 s

    [[nodiscard]] const Endpoint& endpoint() const { return m_endpoint; }
    // Empty for a server that was not started here.
    [[nodiscard]] std::optional<std::uint64_t> residentBytes() const;
    [[nodiscard]] std::optional<std::chrono::duration<double>> processorTime() const;

private:
    Server(Endpoint endpoint, pid_t process, int output) : m_endpoint(endpoint), m_process(process), m_output(output) {}

    Endpoint m_endpoint;
    pid_t m_process = -1;
    int m_output = -1;  // its standard output, held open so that it can go on writing
};

}  // namespace boresight::bench
