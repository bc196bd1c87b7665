// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/messages/permissions.h"

#include "core/base/text.h"

namespace boresight {

Permissions::Permissions() : Permissions(Text::tr("The station has not reported yet.")) {}

}  // namespace boresight
