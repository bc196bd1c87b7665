// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <QDateTime>
#include <QString>

// Times for sentences that are read later: "17:06:10Z" stays true, "in 27 s" does not. Any thread.
namespace boresight {

[[nodiscard]] inline QString timeOfDayText(UtcTime utc)
{
    const auto time = std::chrono::round<std::chrono::seconds>(utc).time_since_epoch();
    return QDateTime::fromSecsSinceEpoch(time.count(), Qt::UTC).toString(QStringLiteral("HH:mm:ss'Z'"));
}

// For times that may be days ago: "2026-11-26 14:02Z".
[[nodiscard]] inline QString dayAndTimeText(UtcTime utc)
{
    const auto time = std::chrono::floor<std::chrono::seconds>(utc).time_since_epoch();
    return QDateTime::fromSecsSinceEpoch(time.count(), Qt::UTC).toString(QStringLiteral("yyyy-MM-dd HH:mm'Z'"));
}

}  // namespace boresight
