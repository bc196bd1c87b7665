// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QString>

namespace boresight {

// "TRACK". For programs, so in no other language.
[[nodiscard]] QString protocolWord(StationState state);

}  // namespace boresight
