// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/server.h"

#include "core/base/text.h"

#include <QSocketNotifier>

#include <sys/epoll.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <optional>
#include <utility>

namespace boresight::rotctld {
namespace {

using namespace std::chrono_literals;

// Limits of one turn: this many clients with this many commands each. A command costs 2…6 µs with its system calls, and
// accepting a client 10…50 µs. With 100 flooding clients a turn took 0.2 ms of processor time (median) and 0.35 ms
// (p99).
constexpr int kClientsPerTurn = 8;
constexpr std::size_t kBacklogPerTurn = 8;
constexpr int kCommandsPerClient = 4;
constexpr int kAcceptsPerTurn = 8;
constexpr std::size_t kReadSize = 1024;

constexpr std::size_t kMaxUnsent = 16384;  // bytes; with more, its commands wait
constexpr auto kUnsentTime = 10s;          // the client has read nothing of its replies for this time
constexpr auto kFloodTime = 10s;           // commands have been waiting without a break for this time
constexpr auto kHalfCommandTime = 60s;
constexpr auto kLingerTime = 2s;  // after our last byte, so that a reset does not destroy it
constexpr auto kHousekeepingPeriod = 100ms;

constexpr std::uint64_t kListenerId = 0;

}  // namespace

struct Server::Connection
{
    Connection(std::uint64_t number, Descriptor opened, std::unique_ptr<Conversation> talk)
        : id(number), socket(std::move(opened)), session(std::move(talk))
    {}

    std::uint64_t id;
    Descriptor socket;
    std::unique_ptr<Conversation> session;
    std::string unsent;
    SteadyTime lastReceived;
    SteadyTime lastSent;                  // the last time the socket took a byte
    std::optional<SteadyTime> busySince;  // since when commands have been waiting without a break
    SteadyTime leftAt;
    bool waiting = false;    // commands wait for the next turn
    bool inputFull = false;  // the last read filled the buffer, so there is probably more
    bool atEnd = false;      // the client sends no more
    bool left = false;       // the session is over; only the last bytes are still sent
    bool sendingEnded = false;
    bool broken = false;  // the socket cannot be used any more
    std::uint32_t watched = 0;
};

Server::Server(ServerSettings settings, StartConversation start, Rotator& rotator, const Clock& clock, QObject* parent)
    : QObject(parent),
      m_settings(std::move(settings)),
      m_start(std::move(start)),
      m_rotator(rotator),
      m_clock(clock),
      m_admission(m_settings.allow),
      m_nextTurn(this),
      m_housekeeping(this)
{
    m_nextTurn.setSingleShot(true);
    m_nextTurn.setInterval(0ms);
    m_housekeeping.setInterval(kHousekeepingPeriod);
    connect(&m_nextTurn, &QTimer::timeout, this, &Server::serveBacklog);
    connect(&m_housekeeping, &QTimer::timeout, this, &Server::housekeep);
}

Server::~Server()
{
    close();
}

Result<> Server::listen()
{
    auto entrance = !m_settings.pty.empty()        ? openTerminal(m_settings.pty)
                    : !m_settings.unixPath.empty() ? openUnix(m_settings.unixPath)
                                                   : openTcp(m_settings.host, m_settings.port);
    if (!entrance) {
        return tl::unexpected(entrance.error());
    }
    m_epoll = Descriptor(::epoll_create1(EPOLL_CLOEXEC));
    if (!m_epoll.valid()) {
        return failure(ErrorCode::Io, Text::tr("cannot watch sockets: %1").arg(toQString(std::strerror(errno))));
    }
    m_entrance = std::move(*entrance);
    watchListener(true);
    m_readiness = std::make_unique<QSocketNotifier>(m_epoll.get(), QSocketNotifier::Read);
    connect(m_readiness.get(), &QSocketNotifier::activated, this, &Server::serveTurn);
    m_housekeeping.start();
    return {};
}

void Server::close()
{
    for (auto& [id, connection] : m_connections) {
        farewell(*connection, Text::tr("the server was closed"));
    }
    m_connections.clear();
    m_backlog.clear();
    m_nextTurn.stop();
    m_housekeeping.stop();
    m_readiness.reset();
    m_entrance.reset();
    m_epoll = Descriptor();
}

std::string Server::address() const
{
    return m_entrance ? m_entrance->address() : std::string();
}

std::uint16_t Server::port() const
{
    return m_entrance ? m_entrance->port() : std::uint16_t{0};
}

std::vector<ClientInfo> Server::clients() const
{
    std::vector<ClientInfo> list;
    list.reserve(m_connections.size());
    for (const auto& [id, connection] : m_connections) {
        if (!connection->left) {
            list.push_back(infoOf(connection->session->client(), connection->session->habits(), m_clock.now()));
        }
    }
    std::ranges::sort(list, {}, &ClientInfo::id);
    return list;
}

void Server::serveTurn()
{
    std::array<epoll_event, kClientsPerTurn> events{};
    const int count = ::epoll_wait(m_epoll.get(), events.data(), kClientsPerTurn, 0);
    for (int i = 0; i < count; ++i) {
        const epoll_event& event = events[static_cast<std::size_t>(i)];
        if (event.data.u64 == kListenerId) {
            acceptWaiting();
        } else {
            serve(event.data.u64, event.events);
        }
    }
    serveBacklog();
}

void Server::acceptWaiting()
{
    for (int i = 0; i < kAcceptsPerTurn; ++i) {
        auto accepted = m_entrance->accept();
        if (!accepted) {
            if (accepted.error() == AcceptFailure::Shortage) {
                watchListener(false);  // housekeeping tries again; connected clients are served meanwhile
            }
            return;
        }
        const Client client = newClient(m_settings, accepted->address);
        if (isTurnedAway(client, m_settings, m_admission, m_rotator)) {
            m_entrance->left(false);
            continue;
        }
        auto connection = std::make_unique<Connection>(client.id, std::move(accepted->socket), m_start(client));
        connection->lastReceived = m_clock.now();
        control(*connection, EPOLL_CTL_ADD, EPOLLIN);
        m_admission.enter(hostOf(client.address));
        m_connections.emplace(client.id, std::move(connection));
        m_rotator.clientConnected(client);
    }
}

void Server::setAllowed(const std::vector<std::string>& entries)
{
    m_admission.setAllowed(entries);
    std::vector<std::uint64_t> unwanted;
    for (const auto& [id, connection] : m_connections) {
        if (!m_admission.admits(hostOf(connection->session->client().address))) {
            unwanted.push_back(id);
        }
    }
    for (const std::uint64_t id : unwanted) {
        disconnect(id, Text::tr("its address is no longer permitted (%1)").arg(QLatin1String(m_settings.allowKey)));
    }
}

bool Server::disconnect(std::uint64_t id, const QString& reason)
{
    const auto found = m_connections.find(id);
    if (found == m_connections.end() || found->second->left) {
        return false;
    }
    farewell(*found->second, reason);
    settle(*found->second);
    return true;
}

void Server::watchListener(bool on)
{
    if (!m_entrance->watch(m_epoll, kListenerId, on)) {
        return;
    }
    if (!on && !m_shortageTold) {
        m_rotator.clientRemark({.address = {}, .protocol = m_settings.protocol},
                               Text::tr("no file descriptor is free, so new clients wait"));
        m_shortageTold = true;
    }
}

// Tells epoll what the connection can use now: input while no command waits and its replies go out, and room for output
// while a reply is unsent. A broken connection is always reported.
void Server::watch(Connection& connection)
{
    const bool served = connection.left || (!connection.waiting && connection.unsent.size() <= kMaxUnsent);
    const bool wantsInput = served && !connection.atEnd;
    const std::uint32_t wanted = (wantsInput ? EPOLLIN : 0U) | (connection.unsent.empty() ? 0U : EPOLLOUT);
    if (wanted != connection.watched) {
        control(connection, EPOLL_CTL_MOD, wanted);
    }
}

void Server::control(Connection& connection, int operation, std::uint32_t events)
{
    epoll_event event{};
    event.events = events;
    event.data.u64 = connection.id;
    if (::epoll_ctl(m_epoll.get(), operation, connection.socket.get(), &event) != 0) {
        connection.broken = true;
    }
    connection.watched = events;
}

void Server::serve(std::uint64_t id, std::uint32_t events)
{
    const auto found = m_connections.find(id);
    if (found == m_connections.end()) {
        return;
    }
    Connection& connection = *found->second;
    // receive() reads the reason why a connection broke. Sending would take it away.
    if ((events & EPOLLOUT) != 0U && (events & EPOLLERR) == 0U) {
        flush(connection);
    }
    if ((events & ~static_cast<std::uint32_t>(EPOLLOUT)) != 0U) {
        receive(connection);
    }
    if (!connection.waiting) {
        runCommands(connection);
    }
    settle(connection);
}

void Server::receive(Connection& connection)
{
    std::array<char, kReadSize> buffer;
    const Received received = receiveSome(connection.socket, buffer.data(), buffer.size());
    connection.atEnd = received.atEnd;
    if (received.atEnd && !m_settings.pty.empty()) {
        connection.unsent.clear();  // nobody reads a closed terminal
    }
    connection.broken = connection.broken || !received.failure.isEmpty();
    connection.inputFull = received.bytes.size() == buffer.size();
    if (connection.left) {
        return;  // after `q` only the end of the input matters
    }
    if (!received.failure.isEmpty()) {
        farewell(connection, Text::tr("lost: %1").arg(received.failure));
    } else if (connection.atEnd) {
        connection.session->endOfInput();
    } else {
        connection.lastReceived = m_clock.now();
        connection.session->receive(received.bytes);
    }
}

void Server::runCommands(Connection& connection)
{
    connection.waiting = false;
    bool more = !connection.left;
    for (int i = 0; more && i < kCommandsPerClient && connection.unsent.size() <= kMaxUnsent; ++i) {
        m_reply.clear();
        more = connection.session->step(m_reply);
        if (!m_reply.empty()) {
            send(connection, m_reply);
        }
    }
    const bool blocked = connection.unsent.size() > kMaxUnsent;
    if (more && !blocked && connection.session->ending().isEmpty() && !connection.broken) {
        if (!connection.busySince) {
            connection.busySince = m_clock.now();
        }
        connection.waiting = true;
        m_backlog.push_back(connection.id);
        m_nextTurn.start();
    } else if (blocked || !connection.inputFull) {
        connection.busySince.reset();
    }
}

void Server::serveBacklog()
{
    const std::size_t count = std::min(m_backlog.size(), kBacklogPerTurn);
    for (std::size_t i = 0; i < count; ++i) {
        const auto found = m_connections.find(m_backlog.front());
        m_backlog.pop_front();
        if (found != m_connections.end()) {
            runCommands(*found->second);
            settle(*found->second);
        }
    }
    if (!m_backlog.empty()) {
        m_nextTurn.start();
    }
}

// One call per reply, because several clients treat one segment as one reply.
void Server::send(Connection& connection, std::string_view reply)
{
    if (connection.unsent.empty()) {
        const auto sent = sendSome(connection.socket, reply);
        connection.broken = connection.broken || !sent;
        reply.remove_prefix(sent.value_or(reply.size()));
        connection.lastSent = m_clock.now();
    }
    connection.unsent.append(reply);
}

void Server::flush(Connection& connection)
{
    const auto sent = sendSome(connection.socket, connection.unsent);
    if (!sent) {
        connection.broken = true;
        connection.unsent.clear();
        return;
    }
    if (*sent > 0) {
        connection.unsent.erase(0, *sent);
        connection.lastSent = m_clock.now();
    }
}

// Brings a connection to its next state after it was served. The connection may be deleted by this.
void Server::settle(Connection& connection)
{
    if (!connection.left && !connection.session->ending().isEmpty()) {
        if (connection.session->dropped()) {
            m_rotator.clientRemark(connection.session->client(),
                                   Text::tr("dropped: %1").arg(connection.session->ending()));
        }
        farewell(connection, connection.session->ending());
    }
    if (!connection.left && connection.broken) {
        farewell(connection, Text::tr("lost: its answers cannot be sent"));
    }
    if (connection.left && connection.unsent.empty() && !connection.sendingEnded) {
        endSending(connection.socket);
        connection.sendingEnded = true;
    }
    if (connection.broken || (connection.sendingEnded && connection.atEnd)) {
        forget(connection);
        return;
    }
    watch(connection);
}

void Server::forget(Connection& connection)
{
    const bool byItself = connection.atEnd && !connection.session->dropped();
    ::epoll_ctl(m_epoll.get(), EPOLL_CTL_DEL, connection.socket.get(), nullptr);  // the terminal stays open
    m_connections.erase(connection.id);
    m_entrance->left(byItself);
}

void Server::farewell(Connection& connection, const QString& reason)
{
    if (connection.left) {
        return;
    }
    connection.left = true;
    connection.leftAt = m_clock.now();
    m_admission.leave(hostOf(connection.session->client().address));
    m_rotator.clientGone(connection.session->client(), reason);
}

QString Server::overdue(const Connection& connection) const
{
    const SteadyTime now = m_clock.now();
    if (!connection.unsent.empty() && now - connection.lastSent > kUnsentTime) {
        return Text::tr("dropped: does not read its answers");
    }
    if (connection.busySince && now - *connection.busySince > kFloodTime) {
        return Text::tr("dropped: floods without waiting for answers");
    }
    if (connection.session->midCommand() && now - connection.lastReceived > kHalfCommandTime) {
        return Text::tr("dropped: left a command unfinished");
    }
    return {};
}

void Server::housekeep()
{
    m_shortageTold = m_shortageTold && !m_entrance->isWatched();
    watchListener(true);
    if (!m_entrance->isWatched()) {
        acceptWaiting();
    }
    std::vector<std::uint64_t> ids;
    ids.reserve(m_connections.size());
    for (const auto& [id, connection] : m_connections) {
        ids.push_back(id);
    }
    for (const std::uint64_t id : ids) {
        Connection& connection = *m_connections.at(id);
        if (connection.left) {
            connection.broken = connection.broken || m_clock.now() - connection.leftAt > kLingerTime;
        } else if (const QString reason = overdue(connection); !reason.isEmpty()) {
            connection.broken = true;
            m_rotator.clientRemark(connection.session->client(), reason);
            farewell(connection, reason);
        } else if (connection.session->paused()) {
            runCommands(connection);
        }
        settle(connection);
    }
}

}  // namespace boresight::rotctld

#include "moc_server.cpp"
