// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/target_alarm.h"

#include "core/base/text.h"

namespace boresight {
namespace {

const QString kOutside = QStringLiteral("target");

}  // namespace

void TargetAlarm::update(const QString& limitedReason)
{
    if (limitedReason.isEmpty()) {
        m_alarms.clear(kOutside);
        return;
    }
    m_alarms.raise(kOutside, Severity::Advisory,
                   {.what = Text::tr("the target is outside the limits"),
                    .action = Text::tr("LIMITED, the nearest permitted point is driven: %1").arg(limitedReason),
                    .remedy = Text::tr("None needed: the mount follows on when the target comes inside")});
}

}  // namespace boresight
