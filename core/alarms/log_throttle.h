// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/base/clock.h"

#include <QHash>
#include <QString>

// Protects the log from lines that somebody outside can cause at will, for example by connections, commands or a loose
// cable. A repeated line of a source is written once in kRepeat, and all lines together at most `burst` times a second.
// The next line contains the number of lines left out. Station thread only.
namespace boresight {

class LogThrottle
{
public:
    static constexpr std::chrono::seconds kRepeat{10};

    LogThrottle(EventLog& log, const Clock& clock, int burst) : m_log(log), m_clock(clock), m_burst(burst) {}

    // False if the line was left out.
    bool add(Severity severity, const QString& source, const QString& text, LogKind kind = LogKind::Event,
             const LoggedAlarm& alarm = {});
    // Always written, for the end of something whose beginning was written.
    void insist(Severity severity, const QString& source, const QString& text, LogKind kind = LogKind::Event,
                const LoggedAlarm& alarm = {});

private:
    struct Line
    {
        QString text;
        LoggedAlarm alarm;  // different alarms may have the same text
        SteadyTime time;
    };

    [[nodiscard]] bool repeated(const QString& source, const QString& text, const LoggedAlarm& alarm,
                                SteadyTime now) const;
    void forgetOld(SteadyTime now);

    EventLog& m_log;
    const Clock& m_clock;
    int m_burst;
    QHash<QString, Line> m_lastLines;  // by source
    SteadyTime m_second{};
    int m_inSecond = 0;
    int m_leftOut = 0;
};

}  // namespace boresight
