// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_entry.h"
#include "tests/ui/sample_status.h"

// Alarms of the catalogue with the examples of the manual, for the tests of the window.
namespace boresight::samples {

[[nodiscard]] inline Alarm alarmOf(const AlarmEntry& entry, std::uint64_t id = 1)
{
    QStringList arguments;
    for (int i = 0; i < entry.argumentCount(); ++i) {
        arguments << QString::fromUtf8(entry.examples[static_cast<std::size_t>(i)]);
    }
    const AlarmText text = textOf(entry, arguments);
    return {.id = id,
            .name = QString::fromLatin1(entry.id),
            .severity = entry.severity,
            .what = text.what,
            .action = text.action,
            .remedy = text.remedy,
            .help = entry.help};
}

// Only this alarm, on a mount that is otherwise well.
[[nodiscard]] inline StationStatus alarmed(const AlarmEntry& entry)
{
    StationStatus status = idle();
    status.alarms = {alarmOf(entry)};
    return status;
}

}  // namespace boresight::samples
