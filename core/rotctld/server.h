// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/rotctld/admission.h"
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

struct ServerSettings
{
    std::string host = "127.0.0.1";          // an address; "0.0.0.0" or "::" opens the port to the network
    std::uint16_t port = 4533;               // 0 picks a free one
    std::size_t maxClients = 900;            // below the usual limit of 1024 descriptors
    std::vector<std::string> allow;          // addresses and networks; empty: everybody who reaches the port
    std::string pty = {};                    // link to a pseudo-terminal, in place of host and port
    std::string unixPath = {};               // socket in the file system, in place of host and port
    std::string protocol = "rotctld";        // the protocol of its clients
    const char* allowKey = "rotctld.allow";  // the key of the profile for `allow`
    bool readsOnly = false;                  // its clients may not move the mount
    // The number of the newest client. All servers of one rotator share it, so a later client has a higher number.
    std::shared_ptr<std::uint64_t> newestClient = std::make_shared<std::uint64_t>(0);
};

struct ClientInfo
{
    std::uint64_t id = 0;
    std::string address;
    std::string program;  // the detected program; if unknown, its protocol unless that is rotctld
    QString lastCommand;  // with the reason if it was refused, or with its changed target
    std::uint64_t oddCommands = 0;
    double commandsPerSecond = 0.0;        // mean over the last seconds
    std::optional<SteadyTime> lastMotion;  // its last command for a motion, accepted or not
    std::optional<Angle> leap;             // size of its steps, if it tracks coarsely
};

class Server : public QObject
{
    Q_OBJECT

public:
    // The rotator and the clock must outlive the server. Nothing is opened before listen().
    Server(ServerSettings settings, StartConversation start, Rotator& rotator, const Clock& clock,
           QObject* parent = nullptr);
    ~Server() override;

    Result<> listen();
    void close();  // drops all clients and closes the port

    [[nodiscard]] std::string address() const;  // "127.0.0.1:4533"; of a pseudo-terminal the path of its link
    [[nodiscard]] std::uint16_t port() const;
    [[nodiscard]] std::vector<ClientInfo> clients() const;
    [[nodiscard]] const std::shared_ptr<std::uint64_t>& newestClient() const { return m_settings.newestClient; }

    // The addresses that may connect from now on. Clients that are not permitted any more are dropped.
    void setAllowed(const std::vector<std::string>& entries);
    // From now on. Connected clients stay.
    void setMaxClients(std::size_t count) { m_settings.maxClients = count; }
    // Drops one client. Its program may connect again. False if no client has this number.
    bool disconnect(std::uint64_t id, const QString& reason);

    // Ends pauses, and drops clients whose time limit has passed. Called by a timer. Tests advance the clock and call
    // it.
    void housekeep();

private:
    struct Connection;
    using Connections = std::unordered_map<std::uint64_t, std::unique_ptr<Connection>>;

    void serveTurn();
    void acceptWaiting();
    [[nodiscard]] bool turnedAway(const Client& client);
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
