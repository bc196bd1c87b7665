// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/alarms/log_throttle.h"
#include "core/base/clock.h"
#include "core/messages/station_status.h"

#include <QString>

// Writes the log lines about sources that ask for motions. A client can cause any number of such lines, so lines about
// clients are throttled. Station thread only.
namespace boresight {

class SourceLog
{
public:
    SourceLog(EventLog& log, const Clock& clock);

    void add(Severity severity, const Source& by, const QString& what, LogKind kind = LogKind::Event);
    // This line is never left out.
    void insist(Severity severity, const Source& by, const QString& what) { m_log.add(severity, by.name, what); }

private:
    EventLog& m_log;
    LogThrottle m_clientLines;
};

}  // namespace boresight
