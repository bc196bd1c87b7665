// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/rotctld/admission.h"
#include "core/rotctld/client_habits.h"
#include "core/rotctld/rotator.h"

#include <QString>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// What all servers of clients have in common, with connections or with datagrams: settings, the list of clients, and
// who is refused. Station thread.
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
    QString lastCommand;  // ClientHabits::lastInWords()
    std::uint64_t oddCommands = 0;
    double commandsPerSecond = 0.0;        // mean over the last seconds
    std::optional<SteadyTime> lastMotion;  // its last command for a motion, accepted or not
    std::optional<Angle> leap;             // size of its steps, if it tracks coarsely
    int errorsInARow = 0;                  // cycles in a row with an error (ErrorCycles)
    std::optional<Error> error = {};       // of the last of them
};

class ClientServer
{
public:
    virtual ~ClientServer() = default;

    virtual Result<> listen() = 0;
    [[nodiscard]] virtual std::string address() const = 0;  // for people; empty if it does not listen
    [[nodiscard]] virtual std::vector<ClientInfo> clients() const = 0;
    // Drops one client. Its program may connect again. False if no client has this number.
    virtual bool disconnect(std::uint64_t id, const QString& reason) = 0;
    // From now on. Connected clients stay.
    virtual void setMaxClients(std::size_t count) = 0;
    // Each tick of the station.
    virtual void tick() {}
};

[[nodiscard]] ClientInfo infoOf(const Client& client, const ClientHabits& habits, SteadyTime now);
// The newest client, from this address.
[[nodiscard]] Client newClient(const ServerSettings& settings, const std::string& address);
// True if its address is not permitted, or too many clients are served. The log gives the reason.
[[nodiscard]] bool isTurnedAway(const Client& client, const ServerSettings& settings, Admission& admission,
                                Rotator& rotator);

}  // namespace boresight::rotctld
