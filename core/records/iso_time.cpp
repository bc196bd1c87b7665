// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/records/iso_time.h"

#include <QDateTime>

namespace boresight::records {

QString isoTime(UtcTime time)
{
    const auto sinceEpoch = std::chrono::floor<std::chrono::milliseconds>(time.time_since_epoch());
    return QDateTime::fromMSecsSinceEpoch(sinceEpoch.count(), Qt::UTC).toString(Qt::ISODateWithMs);
}

}  // namespace boresight::records
