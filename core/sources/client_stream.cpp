// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/client_stream.h"

namespace boresight::sources {

Result<> ClientStream::ask(const request::PointSky& wanted, const Source& by)
{
    return helm().streamTo(wanted.direction, by);
}

Result<> ClientStream::ask(const request::PointAxes& wanted, const Source& by)
{
    return helm().streamTo(wanted.position, by);
}

void ClientStream::gone(const Source& client)
{
    helm().settleStream(client);
}

// A client that only reads the position keeps its last target. Gpredict does so while the error is below its threshold.
void ClientStream::positionRead(std::uint64_t clientId)
{
    helm().confirmStream(clientId);
}

}  // namespace boresight::sources
