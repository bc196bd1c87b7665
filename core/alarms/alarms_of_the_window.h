// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_entry.h"

#include <QCoreApplication>

#include <array>

// The alarms that the window raises itself while no data come from the station. They are in no log.
namespace boresight {

inline constexpr std::array kWindowAlarms{
    AlarmEntry{.id = "window.station-silent",
               .source = "station",
               .severity = Severity::Alarm,
               .what = QT_TRANSLATE_NOOP("Text", "The station has sent no status for %1"),
               .action = QT_TRANSLATE_NOOP("Text", "The window hides the old numbers"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Use the hard-wired emergency stop if the mount moves"),
               .examples = {"2.5 s"}},
    AlarmEntry{.id = "window.stop-unconfirmed",
               .source = "station",
               .severity = Severity::Alarm,
               .what = QT_TRANSLATE_NOOP("Text", "STOP is not confirmed"),
               .action = QT_TRANSLATE_NOOP("Text", "The window sent STOP, but the status does not show it"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Use the hard-wired emergency stop if the mount moves")},
    // Shown while there is no other alarm: how to reset a STOP.
    AlarmEntry{.id = "window.stop-latched",
               .source = "station",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP("Text", "STOP is latched"),
               .action = QT_TRANSLATE_NOOP("Text", "Boresight holds the mount and refuses every motion"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Press Reset stop when the mount may move again"),
               .help = AlarmHelp::ResetStop},
};

}  // namespace boresight
