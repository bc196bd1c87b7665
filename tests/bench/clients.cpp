// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/clients.h"

#include "core/base/numbers.h"

#include <poll.h>
#include <sys/epoll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <thread>
#include <utility>

namespace boresight::bench {
namespace {

using namespace std::chrono_literals;

constexpr auto kReplyTimeout = 5s;
constexpr auto kPositionTimeout = 10s;
const Request kAskPosition{.text = "p\n", .form = ReplyForm::TwoNumbers};

enum class ReplyState
{
    Incomplete,
    Good,
    Bad,
};

std::vector<std::string_view> completeLines(std::string_view text)
{
    std::vector<std::string_view> lines;
    for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
        lines.push_back(text.substr(0, end));
        text.remove_prefix(end + 1);
    }
    return lines;
}

ReplyState judgeReply(ReplyForm form, std::string_view received)
{
    const auto lines = completeLines(received);
    if (lines.empty()) {
        return ReplyState::Incomplete;
    }
    if (lines.back().starts_with("RPRT ")) {
        return form == ReplyForm::Report && lines.back() == "RPRT 0" ? ReplyState::Good : ReplyState::Bad;
    }
    switch (form) {
        case ReplyForm::OneLine:
            return ReplyState::Good;
        case ReplyForm::Report:
            return ReplyState::Incomplete;
        case ReplyForm::TwoNumbers:
            break;
    }
    if (lines.size() < 2) {
        return ReplyState::Incomplete;
    }
    return lines.size() == 2 && parseFinite(lines[0]) && parseFinite(lines[1]) ? ReplyState::Good : ReplyState::Bad;
}

bool sendText(int fd, std::string_view text)
{
    return ::send(fd, text.data(), text.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(text.size());
}

// Appends the data that has arrived. Returns false at the end of the connection, or when nothing came in time.
bool receiveInto(int fd, std::string& text, int flags)
{
    std::array<char, 2048> buffer{};
    const ssize_t count = recv(fd, buffer.data(), buffer.size(), flags);
    if (count > 0) {
        text.append(buffer.data(), static_cast<std::size_t>(count));
    }
    return count > 0;
}

// One request and its reply on a blocking socket.
bool exchange(int fd, const Request& request)
{
    if (!sendText(fd, request.text)) {
        return false;
    }
    std::string received;
    while (judgeReply(request.form, received) == ReplyState::Incomplete) {
        if (!receiveInto(fd, received, 0)) {
            return false;
        }
    }
    return judgeReply(request.form, received) == ReplyState::Good;
}

int millisecondsUntil(SteadyClock::time_point deadline)
{
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - SteadyClock::now());
    return static_cast<int>(std::max<std::int64_t>(left.count(), 0));
}

double microsecondsSince(SteadyClock::time_point start)
{
    return std::chrono::duration<double, std::micro>(SteadyClock::now() - start).count();
}

}  // namespace

double Measurement::percentile(double fraction)
{
    if (microseconds.empty()) {
        return std::nan("");
    }
    std::sort(microseconds.begin(), microseconds.end());
    const auto last = static_cast<double>(microseconds.size() - 1);
    return microseconds[static_cast<std::size_t>(std::ceil(fraction * last))];
}

Result<Clients> Clients::connect(const Endpoint& endpoint, std::size_t count, std::vector<Request> requests)
{
    Clients clients(std::move(requests), epoll_create1(EPOLL_CLOEXEC));
    clients.m_connections.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        Connection& connection = clients.m_connections[i];
        connection.fd = openSocket(0);
        connection.nextRequest = i % clients.m_requests.size();
        if (!connectTo(connection.fd, endpoint) || !exchange(connection.fd, kAskPosition)) {
            return failure(ErrorCode::NoAnswer, QStringLiteral("client %1 got no position").arg(i + 1));
        }
        epoll_event event{.events = EPOLLIN, .data = {.u64 = i}};
        epoll_ctl(clients.m_epoll, EPOLL_CTL_ADD, connection.fd, &event);
    }
    return clients;
}

Clients::Clients(Clients&& other) noexcept
    : m_requests(std::move(other.m_requests)),
      m_epoll(std::exchange(other.m_epoll, -1)),
      m_connections(std::exchange(other.m_connections, {}))
{}

Clients::~Clients()
{
    for (const Connection& connection : m_connections) {
        if (connection.fd >= 0) {
            close(connection.fd);
        }
    }
    if (m_epoll >= 0) {
        close(m_epoll);
    }
}

Measurement Clients::closedLoop(std::chrono::milliseconds duration)
{
    Measurement measurement;
    const auto start = SteadyClock::now();
    const auto end = start + duration;
    for (Connection& connection : m_connections) {
        send(connection, measurement);
    }
    while (SteadyClock::now() < end) {
        serve(end, measurement, [&](Connection& connection) { send(connection, measurement); });
    }
    measurement.elapsed = SteadyClock::now() - start;
    finishOutstanding(measurement);
    return measurement;
}

Measurement Clients::paced(std::chrono::milliseconds period, std::chrono::milliseconds duration)
{
    Measurement measurement;
    const auto start = SteadyClock::now();
    const auto step = std::chrono::nanoseconds(period) / static_cast<std::int64_t>(m_connections.size());
    const auto count = std::chrono::nanoseconds(duration) / step;
    for (std::int64_t i = 0; i < count; ++i) {
        const auto due = start + i * step;
        while (SteadyClock::now() < due) {
            serve(due, measurement, [](Connection&) {});
        }
        Connection& connection = m_connections[static_cast<std::size_t>(i) % m_connections.size()];
        if (connection.waiting) {
            ++measurement.errors;  // no reply within a whole period
        } else {
            send(connection, measurement);
        }
    }
    finishOutstanding(measurement);
    measurement.elapsed = SteadyClock::now() - start;
    return measurement;
}

void Clients::send(Connection& connection, Measurement& measurement)
{
    if (connection.fd < 0) {
        return;
    }
    connection.received.clear();
    connection.waiting = true;
    connection.sentAt = SteadyClock::now();
    if (!sendText(connection.fd, m_requests[connection.nextRequest].text)) {
        drop(connection, measurement);
    }
}

bool Clients::receive(Connection& connection, Measurement& measurement)
{
    if (!receiveInto(connection.fd, connection.received, MSG_DONTWAIT)) {
        drop(connection, measurement);
        return false;
    }
    const ReplyState state = judgeReply(m_requests[connection.nextRequest].form, connection.received);
    if (state == ReplyState::Incomplete) {
        return false;
    }
    if (state == ReplyState::Good && connection.waiting) {
        measurement.microseconds.push_back(microsecondsSince(connection.sentAt));
    } else {
        ++measurement.errors;
    }
    connection.waiting = false;
    connection.nextRequest = (connection.nextRequest + 1) % m_requests.size();
    return true;
}

template <class Answered>
void Clients::serve(SteadyClock::time_point deadline, Measurement& measurement, Answered answered)
{
    std::array<epoll_event, 64> events{};
    const int ready = epoll_wait(m_epoll, events.data(), int(events.size()), millisecondsUntil(deadline));
    for (int i = 0; i < ready; ++i) {
        Connection& connection = m_connections[events[static_cast<std::size_t>(i)].data.u64];
        if (receive(connection, measurement)) {
            answered(connection);
        }
    }
}

void Clients::drop(Connection& connection, Measurement& measurement)
{
    ++measurement.errors;
    close(connection.fd);
    connection.fd = -1;
    connection.waiting = false;
}

void Clients::finishOutstanding(Measurement& measurement)
{
    const auto deadline = SteadyClock::now() + kReplyTimeout;
    const auto isWaiting = [](const Connection& connection) { return connection.waiting; };
    while (std::any_of(m_connections.begin(), m_connections.end(), isWaiting) && SteadyClock::now() < deadline) {
        serve(deadline, measurement, [](Connection&) {});
    }
    measurement.errors +=
        static_cast<std::uint64_t>(std::count_if(m_connections.begin(), m_connections.end(), isWaiting));
}

Result<> awaitPosition(const Endpoint& endpoint)
{
    const auto deadline = SteadyClock::now() + kPositionTimeout;
    while (SteadyClock::now() < deadline) {
        const int fd = openSocket(0);
        const bool known = connectTo(fd, endpoint) && exchange(fd, kAskPosition);
        close(fd);
        if (known) {
            return {};
        }
        std::this_thread::sleep_for(20ms);
    }
    return failure(ErrorCode::NoAnswer, QStringLiteral("no position within 10 s of the start"));
}

Measurement connectAtOnce(const Endpoint& endpoint, std::size_t count)
{
    Measurement measurement;
    const auto start = SteadyClock::now();
    std::vector<pollfd> sockets;
    std::vector<std::string> received(count);
    for (std::size_t i = 0; i < count; ++i) {
        sockets.push_back({.fd = openSocket(SOCK_NONBLOCK), .events = POLLOUT, .revents = 0});
        connectTo(sockets.back().fd, endpoint);
    }
    const auto finish = [&](std::size_t i, bool good) {
        close(sockets[i].fd);
        sockets[i].fd = -1;
        good ? measurement.microseconds.push_back(microsecondsSince(start)) : void(++measurement.errors);
    };
    const auto deadline = start + kReplyTimeout;
    while (measurement.microseconds.size() + measurement.errors < count && SteadyClock::now() < deadline) {
        poll(sockets.data(), sockets.size(), millisecondsUntil(deadline));
        for (std::size_t i = 0; i < count; ++i) {
            if (sockets[i].fd < 0 || sockets[i].revents == 0) {
                continue;
            }
            if (sockets[i].events == POLLOUT) {
                sockets[i].events = POLLIN;
                if (!sendText(sockets[i].fd, kAskPosition.text)) {
                    finish(i, false);
                }
            } else if (!receiveInto(sockets[i].fd, received[i], MSG_DONTWAIT)) {
                finish(i, false);
            } else if (const auto state = judgeReply(kAskPosition.form, received[i]); state != ReplyState::Incomplete) {
                finish(i, state == ReplyState::Good);
            }
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (sockets[i].fd >= 0) {
            finish(i, false);
        }
    }
    measurement.elapsed = SteadyClock::now() - start;
    return measurement;
}

Measurement connectionPerRequest(const Endpoint& endpoint, std::chrono::milliseconds duration)
{
    Measurement measurement;
    const auto start = SteadyClock::now();
    while (SteadyClock::now() < start + duration) {
        const auto began = SteadyClock::now();
        const int fd = openSocket(0);
        if (connectTo(fd, endpoint) && exchange(fd, kAskPosition)) {
            measurement.microseconds.push_back(microsecondsSince(began));
        } else {
            ++measurement.errors;
        }
        close(fd);
    }
    measurement.elapsed = SteadyClock::now() - start;
    return measurement;
}

}  // namespace boresight::bench
