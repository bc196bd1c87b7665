// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/client_move.h"

#include "core/base/text.h"

namespace boresight::sources {

Result<> ClientMove::ask(const request::Move& wanted, const Source& by)
{
    return helm().runAt(wanted.rates, Activity::Running, by,
                        wanted.purpose.isEmpty() ? Text::tr("move") : wanted.purpose);
}

void ClientMove::gone(const Source& client)
{
    if (helm().current().is(Activity::Running) && helm().current().isFor(client)) {
        helm().end(Severity::Advisory, Text::tr("has disconnected, so its motion ends"));
    }
}

}  // namespace boresight::sources
