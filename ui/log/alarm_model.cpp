// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/log/alarm_model.h"

#include "ui/kit/format.h"
#include "ui/kit/lines_view.h"
#include "ui/kit/symbol.h"
#include "ui/kit/theme.h"

#include <algorithm>
#include <tuple>

namespace boresight::ui {

namespace {

constexpr std::size_t kMaxAlarms = 1000;  // far more than in a night; the log file keeps all alarms

bool same(const Alarm& left, const Alarm& right)
{
    return left.id == right.id && (left.id == 0 ? left.name == right.name : left.since == right.since);
}

auto content(const SeenAlarm& seen)
{
    const Alarm& alarm = seen.alarm;
    return std::tie(alarm.severity, alarm.what, alarm.action, alarm.remedy, alarm.active, alarm.acknowledged,
                    seen.ended, seen.place);
}

// An alarm that is not listed any more. If it had ended before, its acknowledgement removed it from the list, unless
// the whole station is gone.
SeenAlarm closed(SeenAlarm seen, UtcTime now, bool newStation)
{
    Alarm& alarm = seen.alarm;
    alarm.acknowledged = alarm.acknowledged || (!alarm.active && !newStation);
    alarm.active = false;
    seen.ended = seen.ended.value_or(now);
    seen.place.reset();
    return seen;
}

SeenAlarm followed(const SeenAlarm& seen, const StationStatus& status, std::size_t place)
{
    SeenAlarm next = seen;
    next.alarm = status.alarms[place];
    next.place = place;
    next.alarm.since = seen.alarm.since;  // an alarm of the window gets a new beginning with every status
    if (!next.alarm.active) {
        next.ended = seen.ended.value_or(computerUtc(status));
    }
    return next;
}

QString stateWord(const SeenAlarm& seen)
{
    return seen.alarm.active ? AlarmModel::tr("active") : AlarmModel::tr("over");
}

// "2026-11-21 17:05:52.000Z to 17:06:10, over, not acknowledged"
QString story(const SeenAlarm& seen)
{
    QString text = dateText(seen.alarm.since);
    if (seen.ended) {
        text = AlarmModel::tr("%1 to %2").arg(text, clockText(*seen.ended));
    }
    return text + QStringLiteral(", ") + stateWord(seen) + QStringLiteral(", ") +
           (seen.alarm.acknowledged ? AlarmModel::tr("acknowledged") : AlarmModel::tr("not acknowledged"));
}

// What happened, what Boresight did, what to do.
QString advice(const Alarm& alarm, QLatin1Char between)
{
    QStringList parts{characterOf(alarm.severity) + alarm.what};
    if (!alarm.action.isEmpty()) {
        parts << AlarmModel::tr("Boresight: %1").arg(alarm.action);
    }
    if (!alarm.remedy.isEmpty()) {
        parts << AlarmModel::tr("To do: %1").arg(alarm.remedy);
    }
    return parts.join(between);
}

}  // namespace

AlarmModel::AlarmModel(QObject* parent) : TableModel({tr("UTC"), tr("State"), tr("Ackn."), tr("What")}, parent) {}

bool AlarmModel::take(const StationStatus& status)
{
    const bool newStation = status.tick < m_tick;
    m_tick = status.tick;
    follow(status, newStation);
    const bool raised = add(status);
    dropEldest();
    return raised;
}

void AlarmModel::follow(const StationStatus& status, bool newStation)
{
    for (std::size_t row = 0; row < m_seen.size(); ++row) {
        const SeenAlarm& seen = m_seen[row];
        if (!seen.place) {
            continue;
        }
        const auto now =
            std::ranges::find_if(status.alarms, [&seen](const Alarm& alarm) { return same(alarm, seen.alarm); });
        const bool gone = newStation || now == status.alarms.end();
        change(row, gone ? closed(seen, computerUtc(status), newStation)
                         : followed(seen, status, static_cast<std::size_t>(now - status.alarms.begin())));
    }
}

void AlarmModel::change(std::size_t row, const SeenAlarm& now)
{
    if (content(m_seen[row]) != content(now)) {
        m_seen[row] = now;
        const int place = static_cast<int>(row);
        Q_EMIT dataChanged(index(place, 0), index(place, columnCount() - 1));
    }
}

bool AlarmModel::add(const StationStatus& status)
{
    bool raised = false;
    for (std::size_t place = 0; place < status.alarms.size(); ++place) {
        const Alarm& alarm = status.alarms[place];
        if (std::ranges::any_of(m_seen, [&](const SeenAlarm& one) { return one.place && same(one.alarm, alarm); })) {
            continue;
        }
        beginInsertRows({}, rowCount(), rowCount());
        const auto ended = alarm.active ? std::nullopt : std::optional(computerUtc(status));
        m_seen.push_back({.alarm = alarm, .ended = ended, .place = place});
        endInsertRows();
        raised = raised || (alarm.active && alarm.severity > Severity::Advisory);
    }
    return raised;
}

void AlarmModel::dropEldest()
{
    if (m_seen.size() > kMaxAlarms) {
        const int surplus = static_cast<int>(m_seen.size() - kMaxAlarms);
        beginRemoveRows({}, 0, surplus - 1);
        m_seen.erase(m_seen.begin(), m_seen.begin() + surplus);
        endRemoveRows();
    }
}

QVariant AlarmModel::data(const QModelIndex& index, int role) const
{
    const SeenAlarm& one = seen(index.row());
    switch (role) {
        case Qt::DisplayRole:
            return cell(one, index.column());
        case Qt::ForegroundRole:
            return currentTheme().colour(one.place ? toneOf(one.alarm.severity) : Tone::Secondary);
        case Qt::ToolTipRole:
            return one.alarm.what;
        case WholeTextRole:
            return QString(story(one) + QLatin1Char('\n') + advice(one.alarm, QLatin1Char('\n')));
        case FileLineRole:
            return QString(story(one) + QStringLiteral("  ") + advice(one.alarm, QLatin1Char(' ')));
        default:
            return {};
    }
}

QString AlarmModel::cell(const SeenAlarm& seen, int column) const
{
    switch (column) {
        case Time:
            return clockText(seen.alarm.since);
        case State:
            return stateWord(seen);
        case Acknowledged:
            return seen.alarm.acknowledged ? tr("yes") : tr("no");
        default:
            return characterOf(seen.alarm.severity) + seen.alarm.what;
    }
}

bool AlarmOrder::lessThan(const QModelIndex& left, const QModelIndex& right) const
{
    const auto& model = static_cast<const AlarmModel&>(*sourceModel());
    const auto key = [&model](int row) {
        const SeenAlarm& one = model.seen(row);
        return std::pair(!one.place, one.place ? static_cast<std::ptrdiff_t>(*one.place) : -row);
    };
    return key(left.row()) < key(right.row());
}

}  // namespace boresight::ui

#include "moc_alarm_model.cpp"
