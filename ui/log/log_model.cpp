// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/log/log_model.h"

#include "ui/kit/format.h"
#include "ui/kit/lines_view.h"
#include "ui/kit/symbol.h"
#include "ui/kit/theme.h"

#include <algorithm>

namespace boresight::ui {

namespace {
constexpr std::size_t kMaxEntries = 5000;         // a night with a command every few seconds; the file keeps the rest
constexpr QLatin1String kOtherClient("client ");  // a client with another protocol than rotctld, see Source
}  // namespace

LogModel::LogModel(QObject* parent) : TableModel({tr("UTC"), tr("Source"), tr("What")}, parent) {}

void LogModel::append(const std::vector<LogEntry>& entries)
{
    if (entries.empty()) {
        return;
    }
    const int first = rowCount();
    beginInsertRows({}, first, first + static_cast<int>(entries.size()) - 1);
    m_entries.insert(m_entries.end(), entries.begin(), entries.end());
    endInsertRows();
    if (m_entries.size() > kMaxEntries) {
        dropEldest();
    }
}

// The log line of a flickering alarm comes later than the alarm. Two axes may have one each in the same tick.
std::optional<int> LogModel::lineOf(const Alarm& alarm) const
{
    const auto fits = [&alarm](const LogEntry& line) {
        return line.alarm == LoggedAlarm{.name = alarm.name, .about = alarm.about} && line.utc >= alarm.since &&
               line.severity == alarm.severity;
    };
    const auto found = std::ranges::find_if(m_entries, fits);
    return found == m_entries.end() ? std::nullopt : std::optional(static_cast<int>(found - m_entries.begin()));
}

void LogModel::dropEldest()
{
    const auto surplus = static_cast<std::ptrdiff_t>(m_entries.size() - kMaxEntries);
    beginRemoveRows({}, 0, static_cast<int>(surplus) - 1);
    m_entries.erase(m_entries.begin(), m_entries.begin() + surplus);
    endRemoveRows();
}

QVariant LogModel::data(const QModelIndex& index, int role) const
{
    const LogEntry& line = entry(index.row());
    if (role == Qt::ForegroundRole && line.severity != Severity::Advisory) {
        return currentTheme().colour(toneOf(line.severity));
    }
    if (role == Qt::ToolTipRole || role == FileLineRole) {
        return logLine(line);
    }
    if (role == WholeTextRole) {
        return QString(clockText(line.utc) + QStringLiteral("Z  ") + sourceText(line.source) + QLatin1Char('\n') +
                       line.text);
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (index.column()) {
        case Time:
            return clockText(line.utc);
        case From:
            return shortSource(line);
        default:
            // Colour is never the only sign: the usual symbols, as characters.
            return characterOf(line.severity) + line.text;
    }
}

void LogFilter::setKind(LogKind kind)
{
    m_kind = kind;
    invalidateFilter();
}

void LogFilter::setSource(LogSource source)
{
    m_source = source;
    invalidateFilter();
}

void LogFilter::setWarningsOnly(bool on)
{
    m_warningsOnly = on;
    invalidateFilter();
}

void LogFilter::setText(const QString& text)
{
    m_text = text;
    invalidateFilter();
}

bool LogFilter::filterAcceptsRow(int row, const QModelIndex&) const
{
    const LogEntry& line = static_cast<const LogModel*>(sourceModel())->entry(row);
    return (!m_kind || line.kind == *m_kind) && (m_source == LogSource::All || sourceOf(line) == m_source) &&
           (!m_warningsOnly || line.severity != Severity::Advisory) &&
           (line.text.contains(m_text, Qt::CaseInsensitive) ||
            shortSource(line).contains(m_text, Qt::CaseInsensitive) ||
            line.source.contains(m_text, Qt::CaseInsensitive));
}

LogSource sourceOf(const LogEntry& entry)
{
    if (entry.source.startsWith(QLatin1String("rotctld")) || entry.source.startsWith(kOtherClient)) {
        return LogSource::Clients;
    }
    const bool isOperator = entry.source == QLatin1String("operator") || entry.source == QLatin1String("shell");
    return isOperator ? LogSource::Operator : LogSource::Station;
}

QString shortSource(const LogEntry& entry)
{
    if (sourceOf(entry) != LogSource::Clients) {
        return sourceText(entry.source);
    }
    const QString source = entry.source.startsWith(kOtherClient) ? entry.source.mid(kOtherClient.size()) : entry.source;
    const qsizetype port = source.lastIndexOf(QLatin1Char(':'));
    return port < 0 ? source : source.section(QLatin1Char(' '), 0, 0) + QLatin1Char(' ') + source.mid(port);
}

QString logLine(const LogEntry& entry)
{
    return dateText(entry.utc) + QStringLiteral("  ") + entry.source + QStringLiteral("  ") + entry.text;
}

}  // namespace boresight::ui

#include "moc_log_model.cpp"
