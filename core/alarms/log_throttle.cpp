// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/alarms/log_throttle.h"

#include "core/base/text.h"

namespace boresight {

bool LogThrottle::repeated(const QString& source, const QString& text, const LoggedAlarm& alarm, SteadyTime now) const
{
    const auto last = m_lastLines.constFind(source);
    return last != m_lastLines.constEnd() && last->text == text && last->alarm == alarm && now - last->time < kRepeat;
}

void LogThrottle::forgetOld(SteadyTime now)
{
    m_lastLines.removeIf([now](const auto& line) { return now - line->time >= kRepeat; });
}

bool LogThrottle::add(Severity severity, const QString& source, const QString& text, LogKind kind,
                      const LoggedAlarm& alarm)
{
    const SteadyTime now = m_clock.now();
    if (now - m_second >= std::chrono::seconds(1)) {
        m_second = now;
        m_inSecond = 0;
        forgetOld(now);
    }
    if (m_inSecond >= m_burst || repeated(source, text, alarm, now)) {
        ++m_leftOut;
        return false;
    }
    if (m_leftOut > 0) {
        m_log.add(Severity::Advisory, QStringLiteral("log"), Text::tr("%1 similar lines left out").arg(m_leftOut));
        m_leftOut = 0;
    }
    insist(severity, source, text, kind, alarm);
    return true;
}

void LogThrottle::insist(Severity severity, const QString& source, const QString& text, LogKind kind,
                         const LoggedAlarm& alarm)
{
    m_lastLines.insert(source, {.text = text, .alarm = alarm, .time = m_clock.now()});
    ++m_inSecond;
    m_log.add(severity, source, text, kind, alarm);
}

}  // namespace boresight
