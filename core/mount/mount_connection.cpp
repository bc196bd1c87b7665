// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mount/mount_connection.h"

#include "core/base/text.h"

namespace boresight {

contacts::InputReading MountConnection::pin(const contacts::BoardPin& /*pin*/) const
{
    return {.problem = Text::tr("this mount has no such pins")};
}

}  // namespace boresight
