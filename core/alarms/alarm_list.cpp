// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/alarms/alarm_list.h"

#include <algorithm>
#include <string_view>
#include <tuple>

namespace boresight {

namespace {

// The sentence about what happened is another.
bool saysOther(const AlarmEntry& now, const AlarmEntry& before)
{
    return std::string_view(now.what) != before.what;
}

}  // namespace

std::vector<AlarmList::Entry>::iterator AlarmList::find(const AlarmKey& key)
{
    return std::ranges::find_if(m_entries, [&key](const Entry& entry) { return entry.key.sharesPlace(key); });
}

std::optional<AlarmText> AlarmList::raise(const AlarmKey& key, Severity severity, const QStringList& arguments,
                                          UtcTime now)
{
    auto entry = find(key);
    if (entry == m_entries.end()) {
        m_entries.push_back({.key = key, .named = {}, .alarm = {.active = false}});
        entry = std::prev(m_entries.end());
    }
    const QStringList named = namedByWhat(*key.entry, arguments);
    Alarm& alarm = entry->alarm;
    const bool isNew =
        !alarm.active || severity > alarm.severity || saysOther(*key.entry, *entry->key.entry) || named != entry->named;
    if (isNew) {
        alarm = Alarm{.id = m_nextId++, .since = now};
    }
    const AlarmText text = textOf(*key.entry, arguments);
    entry->key = key;
    entry->named = named;
    alarm.name = QString::fromLatin1(key.entry->id);
    alarm.about = key.about;
    alarm.severity = severity;
    alarm.what = text.what;
    alarm.action = text.action;
    alarm.remedy = text.remedy;
    return isNew ? std::optional(text) : std::nullopt;
}

bool AlarmList::clear(const AlarmKey& key)
{
    const auto entry = find(key);
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

bool AlarmList::active(const AlarmKey& key) const
{
    return std::ranges::any_of(m_entries,
                               [&key](const Entry& entry) { return entry.alarm.active && entry.key.sharesPlace(key); });
}

std::vector<Alarm> AlarmList::list() const
{
    std::vector<Entry> entries = m_entries;
    // The oldest of equals is more likely the cause than a result.
    std::ranges::sort(entries, {}, [](const Entry& entry) {
        const Alarm& alarm = entry.alarm;
        return std::tuple(!alarm.active, -static_cast<int>(alarm.severity), alarm.acknowledged,
                          entry.key.entry->symptom, alarm.id);
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
