// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/server.h"

#include "core/base/numbers.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <sstream>
#include <thread>
#include <utility>

namespace boresight::bench {
namespace {

using namespace std::chrono_literals;
using SteadyClock = std::chrono::steady_clock;

constexpr auto kStartTimeout = 10s;
constexpr auto kStopTimeout = 5s;
constexpr std::string_view kPortMark = "{port}";
constexpr std::string_view kAnnouncement = "listening on ";

sockaddr_in socketAddress(const Endpoint& endpoint)
{
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = endpoint.address;
    address.sin_port = htons(endpoint.port);
    return address;
}

bool accepts(const Endpoint& endpoint)
{
    const int fd = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const sockaddr_in address = socketAddress(endpoint);
    const bool connected = connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    close(fd);
    return connected;
}

// The kernel's choice of a free port; nobody else takes it in the moment between.
std::uint16_t freePort()
{
    const int fd = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address = socketAddress({.address = htonl(INADDR_LOOPBACK), .port = 0});
    socklen_t size = sizeof address;
    std::uint16_t port = 0;
    if (bind(fd, reinterpret_cast<const sockaddr*>(&address), size) == 0 &&
        getsockname(fd, reinterpret_cast<sockaddr*>(&address), &size) == 0) {
        port = ntohs(address.sin_port);
    }
    close(fd);
    return port;
}

// Starts the command line in a shell of its own; returns the process and the reading end of its standard output.
Result<std::pair<pid_t, int>> spawn(const std::string& command)
{
    std::array<int, 2> output{};
    if (pipe2(output.data(), O_CLOEXEC) != 0) {
        return failure(ErrorCode::Io, "no pipe for the server's output");
    }
    const std::string line = "exec " + command;
    const pid_t process = fork();
    if (process == 0) {
        dup2(output[1], STDOUT_FILENO);
        const int nowhere = open("/dev/null", O_RDWR);
        dup2(nowhere, STDIN_FILENO);
        dup2(nowhere, STDERR_FILENO);
        execl("/bin/sh", "sh", "-c", line.c_str(), static_cast<char*>(nullptr));
        _exit(127);
    }
    close(output[1]);
    if (process < 0) {
        close(output[0]);
        return failure(ErrorCode::Io, "could not start: " + command);
    }
    return std::pair{process, output[0]};
}

// Reads the program's output until it says where it listens.
Result<Endpoint> announcedEndpoint(int output)
{
    std::string text;
    std::array<char, 512> buffer{};
    const auto deadline = SteadyClock::now() + kStartTimeout;
    while (SteadyClock::now() < deadline) {
        pollfd readable{.fd = output, .events = POLLIN, .revents = 0};
        if (poll(&readable, 1, 100) <= 0) {
            continue;
        }
        const ssize_t count = read(output, buffer.data(), buffer.size());
        if (count <= 0) {
            return failure(ErrorCode::NoAnswer, "the server ended before it listened");
        }
        text.append(buffer.data(), static_cast<std::size_t>(count));
        const std::size_t found = text.find(kAnnouncement);
        const std::size_t end = text.find('\n', found);
        if (found != std::string::npos && end != std::string::npos) {
            const std::size_t begin = found + kAnnouncement.size();
            return parseEndpoint(std::string_view(text).substr(begin, end - begin));
        }
    }
    return failure(ErrorCode::NoAnswer, "the server did not say \"listening on HOST:PORT\" within 10 s");
}

bool becomesReady(const Endpoint& endpoint)
{
    const auto deadline = SteadyClock::now() + kStartTimeout;
    while (SteadyClock::now() < deadline) {
        if (accepts(endpoint)) {
            return true;
        }
        std::this_thread::sleep_for(20ms);
    }
    return false;
}

bool endsWithin(pid_t process, std::chrono::milliseconds limit)
{
    const auto deadline = SteadyClock::now() + limit;
    while (SteadyClock::now() < deadline) {
        if (waitpid(process, nullptr, WNOHANG) != 0) {
            return true;
        }
        std::this_thread::sleep_for(10ms);
    }
    return false;
}

}  // namespace

Result<Endpoint> parseEndpoint(std::string_view text)
{
    const std::size_t colon = text.rfind(':');
    if (colon == std::string_view::npos) {
        return failure(ErrorCode::InvalidInput, "not HOST:PORT: " + std::string(text));
    }
    const auto port = parseInteger(text.substr(colon + 1));
    const std::string host(text.substr(0, colon));
    in_addr address{};
    if (!port || *port < 1 || *port > 65535 || inet_pton(AF_INET, host.c_str(), &address) != 1) {
        return failure(ErrorCode::InvalidInput, "not HOST:PORT: " + std::string(text));
    }
    if ((ntohl(address.s_addr) >> 24) != IN_LOOPBACKNET) {
        return failure(ErrorCode::Refused, "only loopback addresses are measured: " + host);
    }
    return Endpoint{.address = address.s_addr, .port = static_cast<std::uint16_t>(*port)};
}

Result<Server> Server::start(const std::string& target)
{
    if (auto running = parseEndpoint(target)) {
        return Server(*running, -1, -1);
    }
    std::string command = target;
    Endpoint endpoint{.address = htonl(INADDR_LOOPBACK), .port = 0};
    if (const std::size_t mark = command.find(kPortMark); mark != std::string::npos) {
        endpoint.port = freePort();
        command.replace(mark, kPortMark.size(), std::to_string(endpoint.port));
    }
    const auto spawned = spawn(command);
    if (!spawned) {
        return tl::unexpected(spawned.error());
    }
    Server server(endpoint, spawned->first, spawned->second);
    if (endpoint.port == 0) {
        const auto announced = announcedEndpoint(server.m_output);
        if (!announced) {
            return tl::unexpected(announced.error());
        }
        server.m_endpoint = *announced;
    } else if (!becomesReady(endpoint)) {
        return failure(ErrorCode::NoAnswer, "nothing listens after 10 s: " + command);
    }
    return server;
}

Server::Server(Server&& other) noexcept
    : m_endpoint(other.m_endpoint),
      m_process(std::exchange(other.m_process, -1)),
      m_output(std::exchange(other.m_output, -1))
{}

Server::~Server()
{
    if (m_process > 0) {
        kill(m_process, SIGTERM);
        if (!endsWithin(m_process, kStopTimeout)) {
            kill(m_process, SIGKILL);
            waitpid(m_process, nullptr, 0);
        }
    }
    if (m_output >= 0) {
        close(m_output);
    }
}

std::optional<std::uint64_t> Server::residentBytes() const
{
    std::ifstream status("/proc/" + std::to_string(m_process) + "/status");
    std::string line;
    while (std::getline(status, line)) {
        std::istringstream words(line);
        std::string key;
        std::uint64_t kilobytes = 0;
        if (words >> key >> kilobytes && key == "VmRSS:") {
            return kilobytes * 1024;
        }
    }
    return std::nullopt;
}

std::optional<std::chrono::duration<double>> Server::processorTime() const
{
    std::ifstream stat("/proc/" + std::to_string(m_process) + "/stat");
    std::string text;
    if (!std::getline(stat, text)) {
        return std::nullopt;
    }
    // proc(5): the second field is the name in parentheses; utime and stime are fields 14 and 15, in clock ticks.
    std::istringstream fields(text.substr(text.rfind(')') + 1));
    std::string skipped;
    for (int field = 3; field < 14; ++field) {
        fields >> skipped;
    }
    double user = 0;
    double system = 0;
    fields >> user >> system;
    return std::chrono::duration<double>((user + system) / static_cast<double>(sysconf(_SC_CLK_TCK)));
}

}  // namespace boresight::bench
