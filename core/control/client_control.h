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

// Decides which of several clients may move the mount. The rule in the profile is one of three. "First": the first
// client has control until it leaves or has asked for no motion during kRelease. "Last": the client that asked last.
// "Locked": only the host that the mount is locked to. The operator can give control to a client, and can make a client
// read-only for as long as it is connected. This class does not decide about reading and stopping. StationControl asks
// it: it starts no motion and ends none. The caller gives the time. Station thread only.
namespace boresight {

class ClientControl
{
public:
    static constexpr std::chrono::seconds kRelease{10};

    using Rules = profile::RotctldSettings;

    // `readsOnly`: the profile makes the client read-only, and nobody can let it move the mount.
    void came(const Source& client, const std::string& host, bool readsOnly = false);
    void gone(const Source& client);

    // Whether this client may move the mount now. The error names the client in control, or what this client waits
    // for.
    [[nodiscard]] Result<> admits(const Rules& rules, const Source& client, SteadyTime now) const;
    // As admits(), but without the wait after a re-arm: the client could end that wait by an act of its own.
    [[nodiscard]] Result<> mayAct(const Rules& rules, const Source& client, SteadyTime now) const;
    // As admits(), for a program of this host that is not connected yet.
    [[nodiscard]] Result<> admitsHost(const Rules& rules, const std::string& host, SteadyTime now) const;
    // The client asks for a motion, which may be refused. Call this before admits().
    void asked(const Source& client, SteadyTime now);
    // The client has moved the mount.
    void moved(const Source& client, SteadyTime now);
    // The client has read the position.
    void read(std::uint64_t clientId, SteadyTime now);
    // The client has read the position while the mount tracks its stream. So it keeps control although its target
    // stands still.
    void followed(std::uint64_t clientId, SteadyTime now);

    // This client has re-armed the drives, which is an act of its own. Every other client that keeps asking for
    // motions has to wait: the mount must not start because a stream continued through the fault. The wait ends when
    // the client asks for nothing during kRelease, acts itself, reconnects, or is given control by the operator.
    void rearmed(const Source& client, SteadyTime now);
    [[nodiscard]] bool waits(std::uint64_t clientId) const;
    // The client sent `R 1`, so it knows of the re-arm.
    void acted(const Source& client);

    // Whether the client is connected and may be given control.
    [[nodiscard]] Result<> mayBeGiven(const Rules& rules, std::uint64_t clientId) const;
    // The operator gives control to this client. It keeps control for kRelease even if it sends nothing.
    Result<> give(const Rules& rules, std::uint64_t clientId, SteadyTime now);
    Result<> setReadOnly(std::uint64_t clientId, bool readOnly);
    // The operator takes control from the clients. Returns the name of the client that had it. Empty: no client had
    // it.
    QString taken(SteadyTime now);
    // A connected client would move the mount if the operator gave control back: it asks for motions, or it had control
    // and continues to read the position. A program that connects for each command counts only after it has asked
    // again.
    [[nodiscard]] bool isWanted(const Rules& rules, SteadyTime now) const;
    // Clients may move the mount again. The client that had control before the operator continues with it.
    void resume(SteadyTime now);

    // The motion commands of this client are accepted, and those of other clients are refused.
    [[nodiscard]] bool hasControl(const Rules& rules, std::uint64_t clientId, SteadyTime now) const;
    [[nodiscard]] bool readOnly(std::uint64_t clientId) const;
    [[nodiscard]] bool locked(const Rules& rules, std::uint64_t clientId) const;
    [[nodiscard]] QString name(std::uint64_t clientId) const;

private:
    struct Connected
    {
        Source client;
        std::string host;
        bool readOnly = false;
        bool boundToRead = false;           // the profile makes it read-only
        std::optional<SteadyTime> asked{};  // when it last asked for a motion
        std::optional<SteadyTime> read{};   // when it last read the position
        int asks = 0;
        bool waits = false;  // another client re-armed the drives
    };
    // A program that connects for each command. Between its connections it is known by the address of its host.
    struct Passer
    {
        SteadyTime asked{};
        bool waits = false;
    };
    // The client that moved the mount last, or that received control.
    struct ActiveClient
    {
        Source client;
        std::string host;
        SteadyTime since{};  // when it sent its last motion command, or received control
        SteadyTime seen{};   // `since`, or later the last time that it read while the mount tracked its stream
        int motions = 0;
        bool given = false;  // control was given to it, and it has not moved the mount yet
        bool left = false;   // it left after a single command, and its host may connect again
    };

    [[nodiscard]] static Result<> mayMove(const Connected& one);
    [[nodiscard]] std::string hostOf(std::uint64_t clientId) const;
    [[nodiscard]] bool hasControl(SteadyTime now) const;  // without regard to the rules
    [[nodiscard]] bool controlHeld(const Rules& rules, SteadyTime now) const;
    [[nodiscard]] bool continues(const Source& client) const;
    [[nodiscard]] QString activeClientText(SteadyTime now) const;

    std::map<std::uint64_t, Connected> m_clients;
    std::map<std::string, Passer> m_passers;  // by host
    std::optional<ActiveClient> m_active;
    SteadyTime m_taken{};  // when the operator last took control
    std::optional<std::uint64_t> m_takenFrom;
};

}  // namespace boresight
