// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/alarms/alarm_list.h"

#include <algorithm>
#include <tuple>

namespace boresight {

std::vector<AlarmList::Entry>::iterator AlarmList::find(const QString& cause)
{
    return std::ranges::find(m_entries, cause, &Entry::cause);
}

bool AlarmList::raise(const QString& cause, Severity severity, const AlarmText& text, UtcTime now)
{
    auto entry = find(cause);
    if (entry == m_entries.end()) {
        m_entries.push_back({.cause = cause, .alarm = {}, .symptom = text.symptom});
        entry = std::prev(m_entries.end());
        entry->alarm.active = false;
    }
    Alarm& alarm = entry->alarm;
    const bool isNew = !alarm.active || severity > alarm.severity || text.what != alarm.what;
    if (isNew) {
        alarm = Alarm{.id = m_nextId++, .since = now};
    }
    entry->symptom = text.symptom;
    alarm.severity = severity;
    alarm.what = text.what;
    alarm.action = text.action;
    alarm.remedy = text.remedy;
    return isNew;
}

bool AlarmList::clear(const QString& cause)
{
    const auto entry = find(cause);
    if (entry == m_entries.end() || !entry->alarm.active) {
        return false;
    }
    entry->alarm.active = false;
    forgetFinished();
    return true;
}

void AlarmList::acknowledgeAll()
{
    for (Entry& entry : m_entries) {
        entry.alarm.acknowledged = true;
    }
    forgetFinished();
}

void AlarmList::acknowledge(std::uint64_t id)
{
    for (Entry& entry : m_entries) {
        entry.alarm.acknowledged = entry.alarm.acknowledged || entry.alarm.id == id;
    }
    forgetFinished();
}

bool AlarmList::active(const QString& cause) const
{
    const auto entry = std::ranges::find(m_entries, cause, &Entry::cause);
    return entry != m_entries.end() && entry->alarm.active;
}

std::vector<Alarm> AlarmList::list() const
{
    std::vector<Entry> entries = m_entries;
    // The oldest of equals is more likely the cause than a result.
    std::ranges::sort(entries, {}, [](const Entry& entry) {
        const Alarm& alarm = entry.alarm;
        return std::tuple(!alarm.active, -static_cast<int>(alarm.severity), alarm.acknowledged, entry.symptom,
                          alarm.id);
    });
    std::vector<Alarm> alarms;
    alarms.reserve(entries.size());
    std::ranges::transform(entries, std::back_inserter(alarms), &Entry::alarm);
    return alarms;
}

void AlarmList::forgetFinished()
{
    std::erase_if(m_entries, [](const Entry& entry) {
        const Alarm& alarm = entry.alarm;
        return !alarm.active && (alarm.acknowledged || alarm.severity == Severity::Advisory);
    });
}

}  // namespace boresight
