// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/base/clock.h"

#include <QHash>
#include <QString>

// Lines that somebody outside can cause at will - connections, commands, a cable that flickers - must not flood the
// log: each source's repeated line is written once in kRepeat, and no more than `burst` lines a second in all; what was
// left out is counted in the next line. Station thread only.
namespace boresight {

class LogThrottle
{
public:
    static constexpr std::chrono::seconds kRepeat{10};

    LogThrottle(EventLog& log, const Clock& clock, int burst) : m_log(log), m_clock(clock), m_burst(burst) {}

    // False if it was left out.
    bool add(Severity severity, const QString& source, const QString& text, LogKind kind = LogKind::Event,
             const LoggedAlarm& alarm = {});
    // Written in any case: the end of something whose beginning was.
    void insist(Severity severity, const QString& source, const QString& text, LogKind kind = LogKind::Event,
                const LoggedAlarm& alarm = {});

private:
    struct Line
    {
        QString text;
        LoggedAlarm alarm;  // two of them may say the same
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
