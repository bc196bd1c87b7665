// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/alarms/event_log.h"

#include <QLoggingCategory>

#include <algorithm>

Q_LOGGING_CATEGORY(lcStation, "boresight.station", QtInfoMsg)

namespace boresight {

void EventLog::add(Severity severity, const QString& source, const QString& text, LogKind kind)
{
    if (severity == Severity::Advisory) {
        qCInfo(lcStation).noquote() << source + QStringLiteral(":") << text;
    } else {
        qCWarning(lcStation).noquote() << source + QStringLiteral(":") << text;
    }
    m_entries.push_back({.number = ++m_lastNumber,
                         .utc = m_clock.utc(),
                         .severity = severity,
                         .source = source,
                         .text = text,
                         .kind = kind});
    if (m_entries.size() > kCapacity) {
        m_entries.pop_front();
    }
}

std::vector<LogEntry> EventLog::since(std::uint64_t number, std::size_t limit) const
{
    const auto first = std::ranges::upper_bound(m_entries, number, {}, &LogEntry::number);
    const auto available = static_cast<std::size_t>(std::distance(first, m_entries.end()));
    const auto skipped = available > limit ? available - limit : 0;
    return {first + static_cast<std::ptrdiff_t>(skipped), m_entries.end()};
}

}  // namespace boresight
