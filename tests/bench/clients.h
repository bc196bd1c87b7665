// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "tests/bench/server.h"

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// Clients of a rotctld server, all on one thread with epoll. As with real clients, a request is sent only after the
// reply to the previous one. Each reply is read to its end and checked: an invalid reply counts as an error.
namespace boresight::bench {

using SteadyClock = std::chrono::steady_clock;

// How the end of a reply is recognised. A line "RPRT -n" ends every reply.
enum class ReplyForm
{
    TwoNumbers,  // p: azimuth and elevation, a line each
    OneLine,     // _ : the server's name
    Report,      // P, S and all extended replies: everything up to a line "RPRT n"
};

struct Request
{
    std::string text;
    ReplyForm form;
};

struct Measurement
{
    std::vector<double> microseconds;  // from sending to the last byte of the reply, one per answered request
    std::uint64_t errors = 0;          // refusals, unreadable replies, lost connections
    std::chrono::duration<double> elapsed{0};

    [[nodiscard]] double perSecond() const { return double(microseconds.size()) / elapsed.count(); }
    // 0.5 is the median. Sorts the values.
    [[nodiscard]] double percentile(double fraction);
};

class Clients
{
public:
    // Connects `count` clients one after the other. Each queries the position once, so that the server has accepted all
    // of them. Client i starts its round of `requests` with the i-th.
    [[nodiscard]] static Result<Clients> connect(const Endpoint& endpoint, std::size_t count,
                                                 std::vector<Request> requests);

    Clients(Clients&& other) noexcept;
    Clients& operator=(Clients&&) = delete;
    Clients(const Clients&) = delete;
    Clients& operator=(const Clients&) = delete;
    ~Clients();

    // Each client sends its next request as soon as it has its reply.
    [[nodiscard]] Measurement closedLoop(std::chrono::milliseconds duration);
    // Each client sends one request in each period, and the clients are spread evenly over the period.
    [[nodiscard]] Measurement paced(std::chrono::milliseconds period, std::chrono::milliseconds duration);

private:
    struct Connection
    {
        int fd = -1;
        std::size_t nextRequest = 0;
        bool waiting = false;
        SteadyClock::time_point sentAt{};
        std::string received;
    };

    Clients(std::vector<Request> requests, int epoll) : m_requests(std::move(requests)), m_epoll(epoll) {}
    void send(Connection& connection, Measurement& measurement);
    // True when the reply is complete.
    bool receive(Connection& connection, Measurement& measurement);
    // Waits for events up to the deadline and handles them. Calls `answered` for each complete reply.
    template <class Answered>
    void serve(SteadyClock::time_point deadline, Measurement& measurement, Answered answered);
    void drop(Connection& connection, Measurement& measurement);
    void finishOutstanding(Measurement& measurement);

    std::vector<Request> m_requests;
    int m_epoll = -1;
    std::vector<Connection> m_connections;
};

// Queries until there is a position, because a mount does not know it right after the start. Fails after 10 s.
[[nodiscard]] Result<> awaitPosition(const Endpoint& endpoint);

// `count` clients connect at the same time and query the position. Measures the time until all have a reply (5 s at
// most).
[[nodiscard]] Measurement connectAtOnce(const Endpoint& endpoint, std::size_t count);

// One client after the other connects, queries the position, and closes without "q". The latency includes the
// connection.
[[nodiscard]] Measurement connectionPerRequest(const Endpoint& endpoint, std::chrono::milliseconds duration);

}  // namespace boresight::bench
