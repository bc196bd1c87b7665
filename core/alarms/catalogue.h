// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_entry.h"
#include "core/alarms/alarms_of_axes.h"
#include "core/alarms/alarms_of_drives.h"
#include "core/alarms/alarms_of_pointing.h"
#include "core/alarms/alarms_of_rotators.h"
#include "core/alarms/alarms_of_the_drive_check.h"
#include "core/alarms/alarms_of_the_station.h"
#include "core/alarms/alarms_of_the_window.h"

#include <string_view>
#include <vector>

// All alarms of Boresight. Each entry is in one of the lists above, where the tables of the manual and the tests find
// it. Code that raises an alarm names its id. An id that is in no list does not compile.
namespace boresight {

// All entries, in the order of the manual.
[[nodiscard]] std::vector<const AlarmEntry*> alarmCatalogue();

namespace detail {

void thisAlarmIsInNoList();  // not constexpr, so a constant expression that calls it does not compile

template <class List>
[[nodiscard]] constexpr const AlarmEntry* findAlarm(const List& list, std::string_view id)
{
    for (const AlarmEntry& entry : list) {
        if (entry.id == id) {
            return &entry;
        }
    }
    return nullptr;
}

}  // namespace detail

[[nodiscard]] consteval const AlarmEntry& alarmEntry(std::string_view id)
{
    const AlarmEntry* found = detail::findAlarm(kDriveAlarms, id);
    found = found != nullptr ? found : detail::findAlarm(kAxisAlarms, id);
    found = found != nullptr ? found : detail::findAlarm(kDriveCheckAlarms, id);
    found = found != nullptr ? found : detail::findAlarm(kStationAlarms, id);
    found = found != nullptr ? found : detail::findAlarm(kRotatorAlarms, id);
    found = found != nullptr ? found : detail::findAlarm(kPointingAlarms, id);
    found = found != nullptr ? found : detail::findAlarm(kWindowAlarms, id);
    if (found == nullptr) {
        detail::thisAlarmIsInNoList();
    }
    return *found;
}

// "warning". For programs and for the manual: in English in every language of the program.
[[nodiscard]] QString severityWord(Severity severity);

// The manual's table of all alarms in Markdown. Example arguments complete the sentences.
[[nodiscard]] QString alarmTable();

}  // namespace boresight
