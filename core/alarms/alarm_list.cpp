// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/alarms/alarm_list.h"

#include <algorithm>
#include <string_view>
#include <tuple>

namespace boresight {

namespace {

// The sentence about what happened differs.
bool saysOther(const AlarmEntry& now, const AlarmEntry& before)
{
    return std::string_view(now.what) != before.what;
}

// Sorts causes of many alarms before alarms that are usually a result.
int depthOf(AlarmKin kin)
{
    switch (kin) {
        case AlarmKin::BusGone:
            return 0;
        case AlarmKin::BusDisturbed:
            return 1;
        case AlarmKin::Alone:
        case AlarmKin::Drive:
            break;
        case AlarmKin::Silence:
            return 3;
    }
    return 2;
}

// Active alarms first, then the higher severity, then unacknowledged alarms.
std::tuple<bool, int, bool> ownUrgencyOf(const Alarm& alarm)
{
    return {!alarm.active, -static_cast<int>(alarm.severity), alarm.acknowledged};
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
    alarm.help = key.entry->help;
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

// A cause has the urgency of the most urgent alarm that it explains.
AlarmList::Urgency AlarmList::urgencyOf(const Entry& entry) const
{
    Urgency urgency = ownUrgencyOf(entry.alarm);
    for (const Entry& other : m_entries) {
        if (entry.alarm.active && other.alarm.active && explains(entry.key, other.key)) {
            urgency = std::min(urgency, ownUrgencyOf(other.alarm));
        }
    }
    return urgency;
}

// A silence on a bus that is gone is not listed.
bool AlarmList::goesWithoutSaying(const Entry& entry) const
{
    return entry.alarm.active && entry.key.entry->kin == AlarmKin::Silence &&
           std::ranges::any_of(m_entries, [](const Entry& other) {
               return other.alarm.active && other.key.entry->kin == AlarmKin::BusGone;
           });
}

std::vector<Alarm> AlarmList::list() const
{
    std::vector<const Entry*> entries;
    for (const Entry& entry : m_entries) {
        if (!goesWithoutSaying(entry)) {
            entries.push_back(&entry);
        }
    }
    // Among equals the oldest alarm comes first, because it is more likely the cause.
    std::ranges::sort(entries, {}, [this](const Entry* entry) {
        return std::tuple(urgencyOf(*entry), depthOf(entry->key.entry->kin), entry->alarm.id);
    });
    std::vector<Alarm> alarms;
    alarms.reserve(entries.size());
    std::ranges::transform(entries, std::back_inserter(alarms), [](const Entry* entry) { return entry->alarm; });
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
