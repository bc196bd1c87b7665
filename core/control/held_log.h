// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/current_motion.h"
#include "core/control/source_log.h"
#include "core/motion/motion.h"

#include <QString>

// Logs what holds a motion: a limit that a jog or run reaches, or a stream that has no way to its target. A missing
// way is logged only once, because its reason names the place of the target, which changes. Station thread only.
namespace boresight {

class HeldLog
{
public:
    explicit HeldLog(SourceLog& log) : m_log(log) {}

    // Once in a tick, after the set-points.
    void look(const CurrentMotion& current, const Motion& motion);

private:
    SourceLog& m_log;
    QString m_at;  // the reason of the last tick
};

}  // namespace boresight
