// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/client_stream.h"

namespace boresight::sources {

bool ClientStream::serves(const Request& request, const Source& by) const
{
    return by.kind == SourceKind::Client || std::holds_alternative<request::TrackForClient>(request);
}

Result<> ClientStream::ask(const request::PointSky& wanted, const Source& by)
{
    return stream(wanted.direction, by);
}

Result<> ClientStream::ask(const request::PointAxes& wanted, const Source& by)
{
    return stream(wanted.position, by);
}

Result<> ClientStream::stream(const OrbitLock::Point& point, const Source& by)
{
    if (m_lock.locks(by)) {
        return helm().mayPoint(by).map([&] { m_lock.compare(point); });
    }
    return std::visit([&](const auto& there) { return helm().streamTo(there, by); }, point).map([&] {
        m_lock.sent(by, point);
    });
}

Result<> ClientStream::ask(const request::TrackForClient& wanted, const Source& by)
{
    return operatorOnly(by).and_then([&] { return m_lock.answer(wanted); });
}

Result<> ClientStream::receive(const SourceReport& report)
{
    if (const auto* const satellites = std::get_if<recognise::SharedSatellites>(&report)) {
        m_lock.setSatellites(*satellites);
    }
    return {};
}

void ClientStream::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    m_lock.profileChanged(before, after);
}

// A locked mount holds. Otherwise it settles at the last target.
void ClientStream::gone(const Source& client)
{
    m_lock.gone(client);
    helm().settleStream(client);
}

// A client that only reads the position keeps its last target. Gpredict does so while the error is below its threshold.
void ClientStream::positionRead(std::uint64_t clientId)
{
    m_lock.positionRead(clientId);
    helm().confirmStream(clientId);
}

}  // namespace boresight::sources
