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
    if (helm().current().is(Activity::Streaming) && helm().current().isFor(client)) {
        helm().settleStream();
    }
}

// A client that reads and sends nothing is content with its last target, as Gpredict is within its threshold.
void ClientStream::positionRead(std::uint64_t clientId)
{
    if (helm().current().is(Activity::Streaming) && helm().current().isForClient(clientId)) {
        helm().confirmStream();
    }
}

}  // namespace boresight::sources
