// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_entry.h"

#include <QCoreApplication>

#include <array>

// The alarms of the station itself: this computer, the bus, its files and clients, and what is wanted of the mount.
namespace boresight {

inline constexpr std::array kStationAlarms{
    AlarmEntry{
        .id = "bus.down",
        .source = "bus",
        .severity = Severity::Alarm,
        .what = "%1",
        .action = QT_TRANSLATE_NOOP("Text", "Nothing can be commanded. Boresight tries the bus again each second"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text", "Remove the fault, or choose another adapter in the guide or another mount on the page Profile"),
        .examples = {"can0 does not exist"}},
    AlarmEntry{
        .id = "bus.left-alone",
        .source = "bus",
        .severity = Severity::Alarm,
        .what = "%1",
        .action = QT_TRANSLATE_NOOP("Text", "Nothing can be commanded. Boresight sends nothing more to this port"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text", "Remove the fault, or choose another adapter in the guide or another mount on the page Profile"),
        .examples = {"/dev/ttyACM0 does not answer as an fdcanusb"},
        .placeOf = "bus.down"},
    AlarmEntry{.id = "bus.trouble",
               .source = "bus",
               .severity = Severity::Warning,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "Boresight continues to use the bus"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Check the plugs, the cable and the termination of the bus"),
               .examples = {"can0 is error passive"},
               .placeOf = "bus.down"},
    AlarmEntry{
        .id = "computer.stalled",
        .source = "station",
        .severity = Severity::Advisory,
        .what = QT_TRANSLATE_NOOP("Text", "This computer stalled for %1 s, and the drives stopped by their watchdogs."),
        .action = QT_TRANSLATE_NOOP("Text", "Boresight takes the drives over and resumes the motion."),
        .remedy = QT_TRANSLATE_NOOP("Text", "None needed. If it happens often, reduce the load of this computer"),
        .examples = {"0.45"}},
    AlarmEntry{
        .id = "rotctld.not-listening",
        .source = "rotctld",
        .severity = Severity::Alarm,
        .what = "%1",
        .action = QT_TRANSLATE_NOOP("Text", "No client can connect. Everything else works"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text",
            "End the other program, or choose another port (--listen, or rotctld.listen), then restart Boresight"),
        .examples = {"another program already uses port 4533"}},
    AlarmEntry{.id = "rotctld.open",
               .source = "rotctld",
               .severity = Severity::Advisory,
               .what = QT_TRANSLATE_NOOP("Text", "every computer that reaches %1 can move the mount"),
               .action = QT_TRANSLATE_NOOP("Text", "Boresight accepts every client"),
               .remedy = QT_TRANSLATE_NOOP(
                   "Text", "Enter the addresses that may connect in rotctld.allow, or listen on 127.0.0.1"),
               .examples = {"0.0.0.0:4533"}},
    AlarmEntry{.id = "journal.in-use",
               .source = "position journal",
               .severity = Severity::Alarm,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "Boresight commands nothing and no client can connect"),
               .remedy = QT_TRANSLATE_NOOP(
                   "Text", "End the other program and press Reconnect, or give this mount another name in its profile"),
               .examples = {"another program controls this mount"}},
    AlarmEntry{
        .id = "journal.not-stored",
        .source = "position journal",
        .severity = Severity::Warning,
        .what = "%1",
        .action = QT_TRANSLATE_NOOP("Text", "Boresight keeps the position of the axes in memory only"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text", "Check the disk or choose another --state-dir. After a restart the cable wrap may be unknown"),
        .examples = {"cannot write the file of the mount: no space left on device"}},
    AlarmEntry{.id = "log.not-stored",
               .source = "log",
               .severity = Severity::Warning,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "Boresight keeps the log in memory only"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Check the disk, or choose another folder with --state-dir"),
               .examples = {"cannot write events.log: no space left on device"}},
    AlarmEntry{.id = "profile.advice",
               .source = "station",
               .severity = Severity::Advisory,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "Boresight uses the profile as it is"),
               .remedy = "%2",
               .examples = {"the azimuth needs 5.0 s and 15° to stop from 6.0°/s",
                            "Raise max_acceleration_deg_s2 (1.2), or lower max_speed_deg_s."}},
    AlarmEntry{
        .id = "mount.no-watchdog",
        .source = "station",
        .severity = Severity::Advisory,
        .what = QT_TRANSLATE_NOOP("Text", "This rotator has no watchdog of its own"),
        .action = QT_TRANSLATE_NOOP("Text", "Boresight commands only one small step ahead"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text", "Keep its power switch in reach. If Boresight or the cable fails, it still ends its last step")},
    AlarmEntry{.id = "target.outside",
               .source = "target",
               .severity = Severity::Advisory,
               .what = QT_TRANSLATE_NOOP("Text", "the target is outside the limits"),
               .action = QT_TRANSLATE_NOOP("Text", "The mount goes to the nearest permitted point (%1)"),
               .remedy = QT_TRANSLATE_NOOP("Text", "None needed. Tracking resumes when the target comes inside"),
               .examples = {"elevation -5.0° below limit 0.0°"}},
    AlarmEntry{
        .id = "cable.turns-back",
        .source = "azimuth",
        .severity = Severity::Advisory,
        .worst = Severity::Warning,
        .what = QT_TRANSLATE_NOOP("Text", "azimuth cable ends at %1, about %2"),
        .action =
            QT_TRANSLATE_NOOP("Text", "At the end Boresight unwinds 360° and resumes. The target is lost for about %3"),
        .remedy = QT_TRANSLATE_NOOP("Text", "To choose the moment, press Unwind earlier, then give control back"),
        .brief = QT_TRANSLATE_NOOP("Text", "ends at %1, about %2"),
        .examples = {"450.0°", "17:06:10Z", "37 s"}},
    AlarmEntry{
        .id = "cable.ends",
        .source = "azimuth",
        .severity = Severity::Advisory,
        .worst = Severity::Warning,
        .what = QT_TRANSLATE_NOOP("Text", "azimuth cable ends at %1, about %2"),
        .action = QT_TRANSLATE_NOOP("Text", "At the end Boresight holds until the target can be reached again"),
        .remedy = QT_TRANSLATE_NOOP("Text", "Widen the limits if the cable allows it, or stop tracking this target"),
        .brief = QT_TRANSLATE_NOOP("Text", "ends at %1, about %2"),
        .examples = {"450.0°", "17:06:10Z"},
        .placeOf = "cable.turns-back"},
};

}  // namespace boresight
