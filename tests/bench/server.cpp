// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/server.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
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

bool accepts(const Endpoint& endpoint)
{
    const int fd = openSocket(0);
    const bool connected = connectTo(fd, endpoint);
    close(fd);
    return connected;
}

// A free port chosen by the kernel. Nothing else is likely to take it before its use.
std::uint16_t freePort()
{
    const int fd = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    std::uint16_t port = 0;
    if (bind(fd, reinterpret_cast<const sockaddr*>(&address), size) == 0 &&
        getsockname(fd, reinterpret_cast<sockaddr*>(&address), &size) == 0) {
        port = ntohs(address.sin_port);
    }
    close(fd);
    return port;
}

// Starts the command line in a separate shell.
Result<Server::Process> spawn(const std::string& command)
{
    std::array<int, 2> output{};
    const int errors = memfd_create("errors", MFD_CLOEXEC);
    if (errors < 0 || pipe2(output.data(), O_CLOEXEC) != 0) {
        return failure(ErrorCode::Io, QStringLiteral("no room for the server's output"));
    }
    const std::string line = "exec " + command;
    const pid_t process = fork();
    if (process == 0) {
        dup2(output[1], STDOUT_FILENO);
        dup2(open("/dev/null", O_RDWR), STDIN_FILENO);
        dup2(errors, STDERR_FILENO);
        execl("/bin/sh", "sh", "-c", line.c_str(), static_cast<char*>(nullptr));
        _exit(127);
    }
    close(output[1]);
    return Server::Process{.id = process, .output = output[0], .errors = errors};
}

// Reads the program's output until it reports where it listens.
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
            return failure(ErrorCode::NoAnswer, QStringLiteral("the server ended before it listened"));
        }
        text.append(buffer.data(), static_cast<std::size_t>(count));
        const std::size_t found = text.find(kAnnouncement);
        const std::size_t end = text.find('\n', found);
        if (found != std::string::npos && end != std::string::npos) {
            const std::size_t begin = found + kAnnouncement.size();
            return parseEndpoint(std::string_view(text).substr(begin, end - begin));
        }
    }
    return failure(ErrorCode::NoAnswer,
                   QStringLiteral("the server did not say \"listening on HOST:PORT\" within 10 s"));
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

Result<Server> Server::start(const std::string& target)
{
    if (auto running = parseEndpoint(target)) {
        return Server(*running, {});
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
    Server server(endpoint, *spawned);
    if (spawned->id < 0) {
        return failure(ErrorCode::Io, QStringLiteral("could not start: %1").arg(toQString(command)));
    }
    if (endpoint.port == 0) {
        const auto announced = announcedEndpoint(server.m_process.output);
        if (!announced) {
            return tl::unexpected(announced.error());
        }
        server.m_endpoint = *announced;
    } else if (!becomesReady(endpoint)) {
        return failure(ErrorCode::NoAnswer, QStringLiteral("nothing listens after 10 s: %1").arg(toQString(command)));
    }
    return server;
}

Server::Server(Server&& other) noexcept : m_endpoint(other.m_endpoint), m_process(std::exchange(other.m_process, {})) {}

Server::~Server()
{
    end();
    for (const int fd : {m_process.output, m_process.errors}) {
        if (fd >= 0) {
            close(fd);
        }
    }
}

std::string Server::end()
{
    const pid_t process = std::exchange(m_process.id, -1);
    if (process <= 0) {
        return {};
    }
    kill(process, SIGTERM);
    if (!endsWithin(process, kStopTimeout)) {
        kill(process, SIGKILL);
        waitpid(process, nullptr, 0);
    }
    std::string text(static_cast<std::size_t>(lseek(m_process.errors, 0, SEEK_END)), '\0');
    const ssize_t count = pread(m_process.errors, text.data(), text.size(), 0);
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    return text;
}

std::optional<std::uint64_t> Server::residentBytes() const
{
    std::ifstream status("/proc/" + std::to_string(m_process.id) + "/status");
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
    std::ifstream stat("/proc/" + std::to_string(m_process.id) + "/stat");
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
