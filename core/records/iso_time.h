// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <QString>

namespace boresight::records {

// UTC to the millisecond in the form of all record files: "2026-11-21T21:34:00.000Z".
[[nodiscard]] QString isoTime(UtcTime time);

}  // namespace boresight::records
