// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/rotctld/client_server.h"
#include "core/rotctld/conversation.h"
#include "core/rotctld/entrance.h"
#include "core/rotctld/rotator.h"
#include "core/rotctld/sockets.h"

#include <QObject>
#include <QTimer>

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

class QSocketNotifier;

// A server of one protocol: listens, reads, lets the Conversation of each client run a few commands per turn, writes
// each reply with one call, and drops clients that misbehave. Lives on the station thread beside the control tick. The
// length of a turn is limited, so no client delays the tick. All sockets are in one epoll set, and the event loop
// watches only this set. So the cost of a turn does not grow with the number of idle clients.
namespace boresight::rotctld {

class Server : public QObject, public ClientServer
{
    Q_OBJECT

public:
    // The rotator and the clock must outlive the server. Nothing is opened before listen().
    Server(ServerSettings settings, StartConversation start, Rotator& rotator, const Clock& clock,
           QObject* parent = nullptr);
    ~Server() override;

    Result<> listen() override;
    void close();  // drops all clients and closes the port

    // "127.0.0.1:4533"; of a pseudo-terminal the path of its link.
    [[nodiscard]] std::string address() const override;
    [[nodiscard]] std::uint16_t port() const;
    [[nodiscard]] std::vector<ClientInfo> clients() const override;
    [[nodiscard]] const std::shared_ptr<std::uint64_t>& newestClient() const { return m_settings.newestClient; }

    // The addresses that may connect from now on. Clients that are not permitted any more are dropped.
    void setAllowed(const std::vector<std::string>& entries);
    bool disconnect(std::uint64_t id, const QString& reason) override;
    void setMaxClients(std::size_t count) override { m_settings.maxClients = count; }

    // Ends pauses, and drops clients whose time limit has passed. Called by a timer. Tests advance the clock and call
    // it.
    void housekeep();

private:
    struct Connection;
    using Connections = std::unordered_map<std::uint64_t, std::unique_ptr<Connection>>;

    void serveTurn();
    void acceptWaiting();
    void watchListener(bool on);
    void control(Connection& connection, int operation, std::uint32_t events);
    void watch(Connection& connection);
    void serve(std::uint64_t id, std::uint32_t events);
    void receive(Connection& connection);
    void runCommands(Connection& connection);
    void send(Connection& connection, std::string_view reply);
    void flush(Connection& connection);
    void serveBacklog();
    void settle(Connection& connection);
    void forget(Connection& connection);
    void farewell(Connection& connection, const QString& reason);
    [[nodiscard]] QString overdue(const Connection& connection) const;

    ServerSettings m_settings;
    StartConversation m_start;
    Rotator& m_rotator;
    const Clock& m_clock;
    Admission m_admission;
    std::unique_ptr<Entrance> m_entrance;  // none while it does not listen
    Descriptor m_epoll;
    std::unique_ptr<QSocketNotifier> m_readiness;
    QTimer m_nextTurn;  // serves clients whose budget ran out, after the other events of the event loop
    QTimer m_housekeeping;
    Connections m_connections;
    std::deque<std::uint64_t> m_backlog;
    bool m_shortageTold = false;
    std::string m_reply;
};

}  // namespace boresight::rotctld
