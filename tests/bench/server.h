// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "tests/bench/sockets.h"

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

// The server under test: either one that already runs at HOST:PORT, or a program started here for one scenario and
// ended with it, so that its memory and processor time can be read. Loopback only. One thread.
namespace boresight::bench {

class Server
{
public:
    struct Process
    {
        pid_t id = -1;
        int output = -1;  // reading end of its standard output, kept open so that the server can go on writing
        int errors = -1;  // a file in memory with its standard error
    };

    // TARGET is HOST:PORT or a command line. A "{port}" in the command line becomes a free port; without it the program
    // must print "… listening on HOST:PORT" on its standard output.
    [[nodiscard]] static Result<Server> start(const std::string& target);

    Server(Server&& other) noexcept;
    Server& operator=(Server&&) = delete;
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;
    ~Server();  // ends it

    // SIGTERM, then SIGKILL after 5 s. Returns the standard error of the program. A second call returns nothing.
    std::string end();

    [[nodiscard]] const Endpoint& endpoint() const { return m_endpoint; }
    // Empty for a server that was not started here.
    [[nodiscard]] std::optional<std::uint64_t> residentBytes() const;
    [[nodiscard]] std::optional<std::chrono::duration<double>> processorTime() const;

private:
    Server(Endpoint endpoint, Process process) : m_endpoint(endpoint), m_process(process) {}

    Endpoint m_endpoint;
    Process m_process;
};

}  // namespace boresight::bench
