// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <QString>

#include <cmath>

// A duration as a text for people: "9 s", "1 min 40 s", "13 h 1 min".
namespace boresight {

[[nodiscard]] inline QString durationText(Seconds time)
{
    constexpr long kMostMinutes = 100;
    const long seconds = std::lround(time.count());
    if (seconds >= 60 * kMostMinutes) {
        const long minutes = (seconds + 30) / 60;
        return QStringLiteral("%1 h %2 min").arg(minutes / 60).arg(minutes % 60);
    }
    return seconds < 100 ? QStringLiteral("%1 s").arg(seconds)
                         : QStringLiteral("%1 min %2 s").arg(seconds / 60).arg(seconds % 60);
}

}  // namespace boresight
