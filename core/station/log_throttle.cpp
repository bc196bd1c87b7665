// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/log_throttle.h"

namespace boresight {

void LogThrottle::add(Severity severity, const QString& source, const QString& text)
{
    const SteadyTime now = m_clock.now();
    if (now - m_second >= std::chrono::seconds(1)) {
        m_second = now;
        m_inSecond = 0;
    }
    const QString line = source + QLatin1Char(' ') + text;
    const bool repeated = line == m_lastLine && now - m_lastTime < kRepeat;
    if (repeated || m_inSecond >= m_burst) {
        ++m_leftOut;
        return;
    }
    if (m_leftOut > 0) {
        m_log.add(Severity::Advisory, QStringLiteral("log"),
                  QStringLiteral("%1 similar lines left out").arg(m_leftOut));
        m_leftOut = 0;
    }
    m_lastLine = line;
    m_lastTime = now;
    ++m_inSecond;
    m_log.add(severity, source, text);
}

}  // namespace boresight
