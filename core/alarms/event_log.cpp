// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/alarms/event_log.h"

#include <QLoggingCategory>

#include <algorithm>

Q_LOGGING_CATEGORY(lcStation, "boresight.station", QtInfoMsg)

namespace boresight {
namespace {

void print(const LogEntry& entry)
{
    if (entry.severity == Severity::Advisory) {
        qCInfo(lcStation).noquote() << plainLine(entry);
    } else {
        qCWarning(lcStation).noquote() << plainLine(entry);
    }
}

}  // namespace

QString plainLine(const LogEntry& entry)
{
    const QString source =
        entry.alarm.name.isEmpty() ? entry.source : QStringLiteral("%1 [%2]").arg(entry.source, entry.alarm.name);
    return source + QStringLiteral(": ") + entry.text;
}

void EventLog::add(Severity severity, const QString& source, const QString& text, LogKind kind,
                   const LoggedAlarm& alarm)
{
    m_entries.push_back({.number = ++m_lastNumber,
                         .utc = m_clock.utc(),
                         .severity = severity,
                         .source = source,
                         .text = text,
                         .kind = kind,
                         .alarm = alarm});
    if (m_echo == Echo::Yes) {
        print(m_entries.back());
    }
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
