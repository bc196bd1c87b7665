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
// gates of a client apply in each tick. A lock begins only while the client moves the mount by its points. It is over
// when the motion of the client ends, for any reason. The setting clients.lock decides whether it begins by itself, is
// offered, or never begins. Station thread only.
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
    void setSatellites(const recognise::SharedSatellites& satellites);
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    void describe(StationStatus& status) const;
    [[nodiscard]] std::optional<SkyPointing> targetAt(UtcTime utc) { return m_track.targetAt(utc); }

private:
    [[nodiscard]] bool isLocked() const { return m_target && m_isLocked; }
    [[nodiscard]] profile::ClientLock rule() const { return m_helm.view().profile.clientLock; }
    [[nodiscard]] SkyPointing directionOf(const Point& point) const;
    [[nodiscard]] bool isNear(const SkyPointing& direction);
    void lookForTarget(SteadyTime now);
    void take(const recognise::Recognition& found);
    void offer(const targets::Target& target, const QStringList& together);
    void tellOnce(const QString& text);
    Result<> lock();
    void watch(SteadyTime now);
    void ended();
    void departed();
    // The lock is over. The notice is on the board for a while.
    void over(const QString& why);
    // The same, and the mount holds.
    void endAndHold(const QString& why);
    void forget();

    Helm& m_helm;
    recognise::SharedSatellites m_satellites = std::make_shared<const std::vector<orbit::ElementSet>>();
    ClientRecognition m_recognition;
    TargetTrack m_track;
    std::optional<Source> m_client;           // whose points are collected, or whose target is locked
    std::uint64_t m_motionId = 0;             // of the motion of this client
    std::optional<targets::Target> m_target;  // offered or locked
    bool m_isLocked = false;
    std::optional<Point> m_departing;  // the last point, if it departs from the locked target
    SteadyTime m_departsSince{};
    SteadyTime m_seen{};  // when the locked client sent a point or read the position
    std::map<std::uint64_t, std::set<QString>> m_answered{};  // targets that are not offered to a client again
    std::map<std::uint64_t, std::set<QString>> m_told{};      // lines that the log has about a client
    std::optional<SteadyTime> m_noticed{};                    // when the notice was raised
};

}  // namespace boresight::sources
