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
        .what = QT_TRANSLATE_NOOP("Text", "The CAN bus is down: %1"),
        .action =
            QT_TRANSLATE_NOOP("Text", "Boresight can command nothing. It tries to open the bus again each second"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text",
            "Check the adapter and its cable. If this is the wrong adapter, choose another one in the guide or on the "
            "page Profile"),
        .brief = "%1",
        .help = AlarmHelp::OpenProfile,
        .kin = AlarmKin::BusGone,
        .examples = {"the adapter is gone: plug it in again"}},
    AlarmEntry{
        .id = "bus.left-alone",
        .source = "bus",
        .severity = Severity::Alarm,
        .what = QT_TRANSLATE_NOOP("Text", "The CAN bus is closed: %1"),
        .action = QT_TRANSLATE_NOOP("Text", "Boresight can command nothing. It sends nothing more to this port"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text",
            "Check the adapter and its cable, then press Reconnect. If this is the wrong port, choose another one in "
            "the guide"),
        .brief = "%1",
        .help = AlarmHelp::Reconnect,
        .kin = AlarmKin::BusGone,
        .examples = {"/dev/ttyACM0 does not answer as an fdcanusb"},
        .placeOf = "bus.down"},
    AlarmEntry{.id = "bus.trouble",
               .source = "bus",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP("Text", "The CAN bus is disturbed: %1"),
               .action = QT_TRANSLATE_NOOP("Text", "Boresight continues to use the bus"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Check the plugs, the cable and the termination of the bus"),
               .brief = "%1",
               .kin = AlarmKin::BusDisturbed,
               .examples = {"can0 is error passive"},
               .placeOf = "bus.down"},
    AlarmEntry{
        .id = "computer.stalled",
        .source = "station",
        .severity = Severity::Advisory,
        .what = QT_TRANSLATE_NOOP("Text", "This computer stalled for %1 s, so the watchdogs stopped the drives"),
        .action = QT_TRANSLATE_NOOP("Text", "Boresight takes the drives over again and resumes the motion"),
        .remedy = QT_TRANSLATE_NOOP("Text", "Nothing to do. If this happens often, reduce the load of this computer"),
        .examples = {"0.45"}},
    AlarmEntry{.id = "computer.slept",
               .source = "station",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP("Text", "This computer was suspended for %1 s"),
               .action = QT_TRANSLATE_NOOP("Text",
                                           "Boresight commanded nothing meanwhile. Drives that were moving stopped "
                                           "by their own watchdog"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Look at the mount. Switch off the suspend of this computer"),
               .examples = {"20.0"}},
    AlarmEntry{.id = "clock.set",
               .source = "station",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP("Text", "The clock of this computer was set by %1 s"),
               .action = QT_TRANSLATE_NOOP("Text", "Boresight computes satellites, Sun and Moon with the new time"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Check the time source if this was not expected"),
               .examples = {"+90.0"}},
    AlarmEntry{.id = "rotctld.not-listening",
               .source = "rotctld",
               .severity = Severity::Alarm,
               .what = QT_TRANSLATE_NOOP("Text", "Clients cannot connect: %1"),
               .action = QT_TRANSLATE_NOOP("Text", "Boresight does everything else without clients"),
               .remedy = QT_TRANSLATE_NOOP("Text",
                                           "End the other program, or choose another port (rotctld.listen on the page "
                                           "Profile). Then restart Boresight"),
               .brief = "%1",
               .help = AlarmHelp::OpenProfile,
               .examples = {"another program already uses port 4533"}},
    AlarmEntry{
        .id = "rotctld.open",
        .source = "rotctld",
        .severity = Severity::Advisory,
        .what = QT_TRANSLATE_NOOP("Text", "Every computer that reaches %1 can move the mount"),
        .action = QT_TRANSLATE_NOOP("Text", "Boresight accepts every client"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text", "Enter the addresses that may connect on the page Profile (rotctld.allow), or listen on 127.0.0.1"),
        .help = AlarmHelp::OpenProfile,
        .examples = {"0.0.0.0:4533"}},
    AlarmEntry{.id = "listener.not-open",
               .source = "listeners",
               .severity = Severity::Alarm,
               .what = QT_TRANSLATE_NOOP("Text", "Further clients cannot connect: %1"),
               .action = QT_TRANSLATE_NOOP("Text", "Boresight serves its other listeners"),
               .remedy = QT_TRANSLATE_NOOP("Text",
                                           "End the other program, or choose another place (listeners.list on the page "
                                           "Profile). Then press Reconnect"),
               .brief = "%1",
               .help = AlarmHelp::Reconnect,
               .examples = {"another program already uses port 4534"}},
    AlarmEntry{
        .id = "listener.open",
        .source = "listeners",
        .severity = Severity::Advisory,
        .what = QT_TRANSLATE_NOOP("Text", "Every computer that reaches %1 can move the mount"),
        .action = QT_TRANSLATE_NOOP("Text", "Boresight accepts every client"),
        .remedy = QT_TRANSLATE_NOOP("Text",
                                    "Add the addresses that may connect to the listener (listeners.list on the page "
                                    "Profile), or let it listen on 127.0.0.1"),
        .help = AlarmHelp::OpenProfile,
        .examples = {"0.0.0.0:4534"}},
    AlarmEntry{
        .id = "journal.in-use",
        .source = "position journal",
        .severity = Severity::Alarm,
        .what = "%1",
        .action = QT_TRANSLATE_NOOP("Text", "Boresight commands nothing and accepts no client"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text", "End the other program, then press Reconnect. If it is another mount, give this one another name"),
        .help = AlarmHelp::Reconnect,
        .examples = {"another program controls this mount"}},
    AlarmEntry{
        .id = "journal.not-stored",
        .source = "position journal",
        .severity = Severity::Warning,
        .what = QT_TRANSLATE_NOOP("Text", "The position journal is not stored: %1"),
        .action = QT_TRANSLATE_NOOP("Text", "Boresight keeps the position of the axes in memory only"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text",
            "Check the disk, or choose another folder with --state-dir. After a restart the cable wrap may be unknown"),
        .brief = "%1",
        .examples = {"cannot write the file of the mount: no space left on device"}},
    AlarmEntry{.id = "log.not-stored",
               .source = "log",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP("Text", "The log is not stored: %1"),
               .action = QT_TRANSLATE_NOOP("Text", "Boresight keeps the log in memory only"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Check the disk, or choose another folder with --state-dir"),
               .brief = "%1",
               .examples = {"cannot write events.log: no space left on device"}},
    AlarmEntry{
        .id = "transmit.output-failed",
        .source = "transmit",
        .severity = Severity::Warning,
        .what = QT_TRANSLATE_NOOP("Text", "The transmit output %1 does not work: %2"),
        .action = QT_TRANSLATE_NOOP("Text", "Boresight counts it as off and tries to switch it again"),
        .remedy = QT_TRANSLATE_NOOP("Text",
                                    "Do not transmit: the output may still be on. Check it, or choose another one "
                                    "(transmit.output on the page Profile)"),
        .brief = QT_TRANSLATE_NOOP("Text", "%1 does not work: %2"),
        .help = AlarmHelp::OpenProfile,
        .examples = {"file:/run/transmit", "/run/transmit: No space left on device"},
        .identifying = 1},
    AlarmEntry{.id = "profile.advice",
               .source = "station",
               .severity = Severity::Advisory,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "Boresight uses the profile as it is"),
               .remedy = "%2",
               .help = AlarmHelp::OpenProfile,
               .examples = {"the azimuth needs 5.0 s and 15° to stop from 6.0°/s",
                            "Raise max_acceleration_deg_s2 (1.2), or lower max_speed_deg_s."}},
    AlarmEntry{
        .id = "mount.no-watchdog",
        .source = "station",
        .severity = Severity::Advisory,
        .what = QT_TRANSLATE_NOOP("Text", "This rotator has no watchdog of its own"),
        .action = QT_TRANSLATE_NOOP("Text", "Boresight commands only small steps"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text",
            "Keep its power switch in reach. If Boresight or the cable fails, the rotator still ends its last step")},
    AlarmEntry{
        .id = "target.outside",
        .source = "target",
        .severity = Severity::Advisory,
        .what = QT_TRANSLATE_NOOP("Text", "The target is outside the limits"),
        .action = QT_TRANSLATE_NOOP("Text", "The mount goes to the nearest permitted point (%1)"),
        .remedy = QT_TRANSLATE_NOOP("Text", "Nothing to do. Tracking resumes when the target comes inside the limits"),
        .examples = {"elevation -5.0° below limit 0.0°"}},
    AlarmEntry{
        .id = "cable.turns-back",
        .source = "azimuth",
        .severity = Severity::Advisory,
        .worst = Severity::Warning,
        .what = QT_TRANSLATE_NOOP("Text", "The azimuth reaches its cable end (%1) at %2"),
        .action = QT_TRANSLATE_NOOP("Text", "Boresight will unwrap the cable by 360° there. The target is lost for %3"),
        .remedy =
            QT_TRANSLATE_NOOP("Text",
                              "Press Unwrap now to choose the moment, then hand control back to the clients. Or press "
                              "Hold at end to wait there"),
        .brief = QT_TRANSLATE_NOOP("Text", "reaches its cable end (%1) at %2"),
        .help = AlarmHelp::Unwind,
        .examples = {"450.0°", "17:06:10Z", "37 s"},
        .identifying = 1},
    AlarmEntry{
        .id = "cable.ends",
        .source = "azimuth",
        .severity = Severity::Advisory,
        .worst = Severity::Warning,
        .what = QT_TRANSLATE_NOOP("Text", "The azimuth reaches its cable end (%1) at %2"),
        .action = QT_TRANSLATE_NOOP("Text", "Boresight will hold there until the mount can reach the target again"),
        .remedy = QT_TRANSLATE_NOOP("Text", "Widen the limits if the cable allows it, or track another target"),
        .brief = QT_TRANSLATE_NOOP("Text", "reaches its cable end (%1) at %2"),
        .help = AlarmHelp::OpenLimits,
        .examples = {"450.0°", "17:06:10Z"},
        .identifying = 1,
        .placeOf = "cable.turns-back"},
};

}  // namespace boresight
