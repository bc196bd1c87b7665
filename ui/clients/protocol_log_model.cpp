// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/clients/protocol_log_model.h"

#include "core/messages/station_status.h"
#include "ui/kit/format.h"
#include "ui/kit/lines_view.h"
#include "ui/kit/symbol.h"
#include "ui/kit/theme.h"

#include <algorithm>

namespace boresight::ui {

namespace {

// "17:05:59.120"
QString clockTextToMillisecond(UtcTime utc)
{
    return dateText(utc).section(QLatin1Char(' '), 1).chopped(1);
}

QString wholeLineText(const ProtocolLine& line)
{
    const QString head = clockTextToMillisecond(line.utc) + QStringLiteral("Z  ") + line.client;
    return QStringList{line.odd ? ProtocolLogModel::tr("%1, odd command").arg(head) : head,
                       ProtocolLogModel::tr("Line: %1").arg(bytesText(line.line)),
                       ProtocolLogModel::tr("Understood: %1").arg(understoodText(line)),
                       ProtocolLogModel::tr("Answer: %1").arg(bytesText(line.answer))}
        .join(QLatin1Char('\n'));
}

}  // namespace

ProtocolLogModel::ProtocolLogModel(QObject* parent)
    : TableModel({tr("UTC"), tr("Client"), tr("Line"), tr("Understood"), tr("Answer")}, parent)
{}

void ProtocolLogModel::append(const std::vector<ProtocolLine>& lines)
{
    if (lines.empty()) {
        return;
    }
    const bool isNewStation = lines.front().number <= m_last;
    m_last = lines.back().number;
    // After a gap the lines before it are older than all lines that the station has kept.
    if (isNewStation || lines.size() >= kMostLines) {
        replace(lines);
        return;
    }
    const int first = rowCount();
    beginInsertRows({}, first, first + static_cast<int>(lines.size()) - 1);
    m_lines.insert(m_lines.end(), lines.begin(), lines.end());
    endInsertRows();
    if (m_lines.size() > kMostLines) {
        dropEldest();
    }
}

void ProtocolLogModel::replace(const std::vector<ProtocolLine>& lines)
{
    const std::size_t kept = std::min(lines.size(), kMostLines);
    beginResetModel();
    m_lines.assign(lines.end() - static_cast<std::ptrdiff_t>(kept), lines.end());
    endResetModel();
}

void ProtocolLogModel::dropEldest()
{
    const auto surplus = static_cast<std::ptrdiff_t>(m_lines.size() - kMostLines);
    beginRemoveRows({}, 0, static_cast<int>(surplus) - 1);
    m_lines.erase(m_lines.begin(), m_lines.begin() + surplus);
    endRemoveRows();
}

QVariant ProtocolLogModel::data(const QModelIndex& index, int role) const
{
    const ProtocolLine& one = line(index.row());
    if (role == Qt::ForegroundRole && one.odd) {
        return currentTheme().colour(Tone::Warning);
    }
    if (role == Qt::ToolTipRole || role == WholeTextRole) {
        return wholeLineText(one);
    }
    if (role == FileLineRole) {
        return fileText(one);
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (index.column()) {
        case Time:
            return clockTextToMillisecond(one.utc);
        case Client:
            return shortClient(one.client);
        case Line:
            // Colour is never the only sign.
            return one.odd ? characterOf(Severity::Warning) + bytesText(one.line) : bytesText(one.line);
        case Understood:
            return understoodText(one);
        default:
            return bytesText(one.answer);
    }
}

void ProtocolLogFilter::setClient(std::uint64_t id)
{
    m_client = id;
    invalidateFilter();
}

bool ProtocolLogFilter::filterAcceptsRow(int row, const QModelIndex&) const
{
    return m_client == 0 || static_cast<const ProtocolLogModel*>(sourceModel())->line(row).clientId == m_client;
}

QString shortClient(const QString& client)
{
    const qsizetype port = client.lastIndexOf(QLatin1Char(':'));
    return port < 0 ? client : client.section(QLatin1Char(' '), 0, 0) + QLatin1Char(' ') + client.mid(port);
}

}  // namespace boresight::ui

#include "moc_protocol_log_model.cpp"
