// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "tests/bench/server.h"

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// Clients of a rotctld server, all on one thread with epoll. A request is sent only after the reply to the one before,
// as real clients do, and each reply is read to its end and looked at: an answer that is no answer counts as an error.
namespace boresight::bench {

using SteadyClock = std::chrono::steady_clock;

// How the end of a reply is recognised. A line "RPRT -n" ends any of them.
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
    // 0.5 is the median. Sorts.
    [[nodiscard]] double percentile(double fraction);
};

class Clients
{
public:
    // Connects `count` clients one after the other and lets each ask for the position once, so that the server has
    // accepted all of them. Client i begins its round of `requests` at the i-th.
    [[nodiscard]] static Result<Clients> connect(const Endpoint& endpoint, std::size_t count,
                                                 std::vector<Request> requests);

    Clients(Clients&& other) noexcept;
    Clients& operator=(Clients&&) = delete;
    Clients(const Clients&) = delete;
    Clients& operator=(const Clients&) = delete;
    ~Clients();

    // Each client asks again as soon as it has its reply.
    [[nodiscard]] Measurement closedLoop(std::chrono::milliseconds duration);
    // Each client asks once per period, the clients spread evenly over it.
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
    // Waits for events up to the deadline and takes them in; calls `answered` for each complete reply.
    template <class Answered>
    void serve(SteadyClock::time_point deadline, Measurement& measurement, Answered answered);
    void drop(Connection& connection, Measurement& measurement);
    void finishOutstanding(Measurement& measurement);

    std::vector<Request> m_requests;
    int m_epoll = -1;
    std::vector<Connection> m_connections;
};

// Asks until there is a position: a mount that has just been started does not know it yet. Fails after 10 s.
[[nodiscard]] Result<> awaitPosition(const Endpoint& endpoint);

// `count` clients connect at once and ask for the position: the time until all have been answered (5 s at most).
[[nodiscard]] Measurement connectAtOnce(const Endpoint& endpoint, std::size_t count);

// One client after the other: connect, ask for the position, close without "q". Latency includes the connection.
[[nodiscard]] Measurement connectionPerRequest(const Endpoint& endpoint, std::chrono::milliseconds duration);

}  // namespace boresight::bench
