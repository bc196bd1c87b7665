// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <QString>

#include <cmath>

// How long something takes, as people read it: "9 s", "1 min 40 s".
namespace boresight {

[[nodiscard]] inline QString durationText(Seconds time)
{
    const long seconds = std::lround(time.count());
    return seconds < 100 ? QStringLiteral("%1 s").arg(seconds)
                         : QStringLiteral("%1 min %2 s").arg(seconds / 60).arg(seconds % 60);
}

}  // namespace boresight
