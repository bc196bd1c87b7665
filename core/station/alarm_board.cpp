// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/alarm_board.h"

namespace boresight {
namespace {

constexpr int kLinesPerSecond = 4;

}  // namespace

AlarmBoard::AlarmBoard(EventLog& log, const Clock& clock) : m_clock(clock), m_lines(log, clock, kLinesPerSecond) {}

void AlarmBoard::raise(const QString& cause, Severity severity, const AlarmText& text)
{
    if (m_alarms.raise(cause, severity, text, m_clock.utc())) {
        // The line begins with the cause: "azimuth drive: fault 38: …".
        const QString named = cause + QLatin1Char(' ');
        const QString what = text.what.startsWith(named) ? text.what.sliced(named.size()) : text.what;
        m_lines.add(severity, cause, what + QStringLiteral(". ") + text.action + QStringLiteral(". ") + text.remedy);
    }
}

void AlarmBoard::clear(const QString& cause)
{
    if (m_alarms.clear(cause)) {
        m_lines.add(Severity::Advisory, cause, QStringLiteral("the alarm is over"));
    }
}

}  // namespace boresight
