// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/helm.h"
#include "core/messages/request.h"
#include "core/sources/client_recognition.h"
#include "core/sources/target_track.h"

#include <map>
#include <optional>
#include <set>
#include <variant>

// Recognises the target that the client in control tracks, and locks to it: Boresight tracks the target from its own
// orbit, and the points of the client are only compared with it. The client stays the source of the motion, so all
// gates of a client apply in each tick. A lock begins only while the client moves the mount by its points and reads the
// position. It is over when the motion of the client ends, for any reason. The setting clients.lock decides whether it
// begins by itself, is offered, or never begins. It begins by itself only when the points have moved along the target.
// Station thread only.
namespace boresight::sources {

class OrbitLock
{
public:
    // As a client sends it: a direction, or the axis angles of a client that counts the turns.
    using Point = std::variant<SkyPointing, AxisPosition>;

    explicit OrbitLock(Helm& helm) : m_helm(helm), m_track(helm) {}

    // Boresight tracks the target of this client, so its points do not move the mount.
    [[nodiscard]] bool locks(const Source& client) const;
    // A point of the locked client.
    void compare(const Point& point);
    // A point that moved the mount.
    void sent(const Source& client, const Point& point);
    void positionRead(std::uint64_t clientId);

    // The operator answers the offer.
    Result<> answer(const request::TrackForClient& answer);

    void step(SteadyTime now);
    void gone(const Source& client);
    // A lock keeps the elements with which it began.
    void setSatellites(const recognise::SharedSatellites& satellites) { m_satellites = satellites; }
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    void describe(StationStatus& status) const;
    [[nodiscard]] std::optional<SkyPointing> targetAt(UtcTime utc) { return m_track.targetAt(utc); }

private:
    struct Offered
    {
        targets::Target target;
        Angle lead;  // of the client
    };
    // The points of a client move the mount, and its target is looked for.
    struct Stream
    {
        Source client;
        std::uint64_t motionId = 0;
        ClientRecognition recognition = {};
        std::optional<SteadyTime> read = {};  // when the client last read the position
        std::optional<Offered> offered = {};
        std::set<QString> told = {};  // what the log has a line about
    };
    struct Departure
    {
        Point last;
        SteadyTime since;
    };
    struct Locked
    {
        Source client;
        QString target;
        Angle lead;                               // how far ahead of the target the client aims
        SteadyTime seen;                          // when the client sent a point or read the position
        std::optional<Departure> departing = {};  // its last point is away from the target
    };
    // What the notice says about the end of a lock.
    struct Ending
    {
        QString why;
        QString action;
        QString remedy;
    };

    [[nodiscard]] SkyPointing directionOf(const Point& point) const;
    [[nodiscard]] bool isNear(const SkyPointing& direction);
    [[nodiscard]] bool goesOn() const;
    [[nodiscard]] bool isReading(SteadyTime now) const;
    void lookForTarget(SteadyTime now);
    void take(const recognise::Recognition& found);
    void takeTarget(const recognise::Recognition& found);
    void tellOnce(const QString& about, const QString& text);
    Result<> lock();
    void watch(SteadyTime now);
    [[nodiscard]] static Ending held(const QString& why);
    [[nodiscard]] std::optional<Ending> endOfMotion() const;
    void ended();
    void departed();
    // The lock is over. The notice is on the board for a while.
    void over(const Ending& ending);
    // The same, and the mount holds.
    void endAndHold(const QString& why);
    void forgetLock();

    Helm& m_helm;
    recognise::SharedSatellites m_satellites = std::make_shared<const std::vector<orbit::ElementSet>>();
    TargetTrack m_track;
    std::optional<Stream> m_stream;
    std::optional<Locked> m_locked;
    std::map<std::uint64_t, std::set<QString>> m_declined{};  // targets that a client does not get again
    std::optional<SteadyTime> m_noticed{};                    // when the notice was raised
};

}  // namespace boresight::sources
