// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_entry.h"

#include <QCoreApplication>

#include <array>

// The alarms that the window raises itself while the station is silent. They are in no log.
namespace boresight {

inline constexpr std::array kWindowAlarms{
    AlarmEntry{.id = "window.station-silent",
               .source = "station",
               .severity = Severity::Alarm,
               .what = QT_TRANSLATE_NOOP("Text", "No word from the station for %1"),
               .action = QT_TRANSLATE_NOOP("Text", "Old numbers are not shown"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Use the hard-wired emergency stop if the mount moves"),
               .examples = {"2.5 s"}},
    AlarmEntry{.id = "window.stop-unconfirmed",
               .source = "station",
               .severity = Severity::Alarm,
               .what = QT_TRANSLATE_NOOP("Text", "STOP is not confirmed"),
               .action = QT_TRANSLATE_NOOP("Text", "It was sent, but the status does not show it"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Use the hard-wired emergency stop if the mount moves")},
};

}  // namespace boresight
