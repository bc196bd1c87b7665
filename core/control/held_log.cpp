// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/held_log.h"

#include "core/base/text.h"

namespace boresight {

void HeldLog::look(const CurrentMotion& current, const Motion& motion)
{
    const bool held = motion.held(Axis::Azimuth) || motion.held(Axis::Elevation);
    const QString at = held                       ? Text::tr("held at %1").arg(motion.obstacle())
                       : motion.noWay().isEmpty() ? QString()
                                                  : Text::tr("held: %1").arg(motion.noWay());
    const bool pressed = current.runsFreely() || (current.is(Activity::Streaming) && !motion.noWay().isEmpty());
    if (pressed && !at.isEmpty() && (m_at.isEmpty() || (held && at != m_at))) {
        m_log.add(Severity::Warning, current.commander(), at);
    }
    m_at = pressed ? at : QString();
}

}  // namespace boresight
