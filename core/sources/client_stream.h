// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/motion_source.h"
#include "core/sources/orbit_lock.h"

// A client sends one target after the other. After the client has disconnected, the mount settles at the last target.
// While Boresight is locked to the target of the client, the client's points do not move the mount, and the mount holds
// when the client disconnects. Station thread only.
namespace boresight::sources {

class ClientStream : public SourceOf<ClientStream, request::PointSky, request::PointAxes, request::TrackForClient>
{
public:
    explicit ClientStream(Helm& helm) : SourceOf(helm), m_lock(helm) {}

    Result<> ask(const request::PointSky& wanted, const Source& by);
    Result<> ask(const request::PointAxes& wanted, const Source& by);
    Result<> ask(const request::TrackForClient& wanted, const Source& by);
    void step(SteadyTime now) override { m_lock.step(now); }
    void describe(StationStatus& status) const override { m_lock.describe(status); }
    Result<> receive(const SourceReport& report) override;
    [[nodiscard]] std::optional<SkyPointing> targetAt(UtcTime utc) override { return m_lock.targetAt(utc); }
    void profileChanged(const profile::Profile& before, const profile::Profile& after) override;
    void gone(const Source& client) override;
    void positionRead(std::uint64_t clientId) override;

protected:
    [[nodiscard]] bool serves(const Request& request, const Source& by) const override;

private:
    Result<> stream(const OrbitLock::Point& point, const Source& by);

    OrbitLock m_lock;
};

}  // namespace boresight::sources
