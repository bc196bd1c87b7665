// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/messages/permissions.h"

#include "core/base/text.h"

namespace boresight {

Permissions::Permissions() : Permissions(Text::tr("nothing is known of the station yet")) {}

}  // namespace boresight
