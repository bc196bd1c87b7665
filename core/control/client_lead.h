// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/messages/station_status.h"
#include "core/profile/profile.h"

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

// Which of several clients may move the mount. By the profile's rule it is the first, who leads until it has asked for
// no motion for kRelease or left; or the last; or only the host that the mount is locked to. The operator can give the
// lead to a client, and make one read-only for as long as it is connected. Reading and stopping are not its business.
// A gate that StationControl asks: starts no motion and ends none; the time is handed in. Station thread only.
namespace boresight {

class ClientLead
{
public:
    static constexpr std::chrono::seconds kRelease{10};

    using Rules = profile::RotctldSettings;

    // `readsOnly`: by the profile, so that nobody can let it move the mount.
    void came(const Source& client, const std::string& host, bool readsOnly = false);
    void gone(const Source& client);

    // May this client move the mount now? The error names the client in control, or what this client waits for.
    [[nodiscard]] Result<> admits(const Rules& rules, const Source& client, SteadyTime now) const;
    // The same, but for the wait after a re-arm: it could take the control by an act of its own.
    [[nodiscard]] Result<> mayAct(const Rules& rules, const Source& client, SteadyTime now) const;
    // The same for a program of this host that is no client yet.
    [[nodiscard]] Result<> admitsHost(const Rules& rules, const std::string& host, SteadyTime now) const;
    // It asks for a motion, whatever the answer will be. Call before admits().
    void asked(const Source& client, SteadyTime now);
    // It has moved the mount.
    void moved(const Source& client, SteadyTime now);
    // It reads where the mount is.
    void read(std::uint64_t clientId, SteadyTime now);
    // It reads where the mount is, which follows it: it is there, though its target stands still for a while.
    void followed(std::uint64_t clientId, SteadyTime now);

    // This client has re-armed the drives, which is an act of its own. Every other client that keeps asking for motions
    // waits: the mount must not set off because a stream went on through the fault. The wait ends when the client asks
    // for nothing during kRelease, acts itself, reconnects, or is given control by the operator.
    void rearmed(const Source& client, SteadyTime now);
    [[nodiscard]] bool waits(std::uint64_t clientId) const;
    // It sent R 1: it knows of the re-arm.
    void acted(const Source& client);

    // Whether it is here, and not locked out.
    [[nodiscard]] Result<> mayBeGiven(const Rules& rules, std::uint64_t clientId) const;
    // By the operator: this client has control from now on, for kRelease even if it sends nothing.
    Result<> give(const Rules& rules, std::uint64_t clientId, SteadyTime now);
    Result<> setReadOnly(std::uint64_t clientId, bool readOnly);
    // The operator takes control from the clients. The one that had it is the answer; empty: none had.
    QString taken(SteadyTime now);
    // A client that is here would move the mount if the operator gave control back: it asks for motions, or it had
    // control and goes on reading the position. A program that connects for each command counts once it asks again.
    [[nodiscard]] bool isWanted(const Rules& rules, SteadyTime now) const;
    // Clients may move the mount again. The client that had control before the operator continues.
    void resume(SteadyTime now);

    // Its motion commands are accepted and those of others are not.
    [[nodiscard]] bool leads(const Rules& rules, std::uint64_t clientId, SteadyTime now) const;
    [[nodiscard]] bool readOnly(std::uint64_t clientId) const;
    [[nodiscard]] bool locked(const Rules& rules, std::uint64_t clientId) const;
    [[nodiscard]] QString name(std::uint64_t clientId) const;

private:
    struct Connected
    {
        Source client;
        std::string host;
        bool readOnly = false;
        bool boundToRead = false;           // by the profile
        std::optional<SteadyTime> asked{};  // for a motion, last
        std::optional<SteadyTime> read{};   // the position, last
        int asks = 0;
        bool waits = false;  // since another client re-armed
    };
    // A program that connects for each command goes on under its host's address.
    struct Passer
    {
        SteadyTime asked{};
        bool waits = false;
    };
    // The client that moved the mount last, or that received control.
    struct Leader
    {
        Source client;
        std::string host;
        SteadyTime since{};  // its last motion command, or the operator's word
        SteadyTime seen{};   // the same, or that it was followed
        int motions = 0;
        bool given = false;  // and has not moved the mount yet
        bool left = false;   // after a single command: its host may come again
    };

    [[nodiscard]] static Result<> mayMove(const Connected& one);
    [[nodiscard]] std::string hostOf(std::uint64_t clientId) const;
    [[nodiscard]] bool leads(SteadyTime now) const;  // whatever the rules are
    [[nodiscard]] bool leadHeld(const Rules& rules, SteadyTime now) const;
    [[nodiscard]] bool continues(const Source& client) const;
    [[nodiscard]] QString leaderText(SteadyTime now) const;

    std::map<std::uint64_t, Connected> m_clients;
    std::map<std::string, Passer> m_passers;  // by host
    std::optional<Leader> m_leader;
    SteadyTime m_taken{};  // by the operator, last
    std::optional<std::uint64_t> m_takenFrom;
};

}  // namespace boresight
