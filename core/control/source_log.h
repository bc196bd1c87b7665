// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/alarms/log_throttle.h"
#include "core/base/clock.h"
#include "core/messages/station_status.h"

#include <QString>

// Writes the log lines of those who ask for motions. Clients can cause such lines at will, so theirs are throttled.
// Station thread only.
namespace boresight {

class SourceLog
{
public:
    SourceLog(EventLog& log, const Clock& clock);

    void add(Severity severity, const Source& by, const QString& what, LogKind kind = LogKind::Event);
    // Never left out.
    void insist(Severity severity, const Source& by, const QString& what) { m_log.add(severity, by.name, what); }

private:
    EventLog& m_log;
    LogThrottle m_clientLines;
};

}  // namespace boresight
