// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QString>

namespace boresight {

// The name of a state for programs, for example "TRACK". It is never translated.
[[nodiscard]] QString protocolWord(StationState state);

}  // namespace boresight
