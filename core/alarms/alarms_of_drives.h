// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_entry.h"

#include <QCoreApplication>

#include <array>

// The alarms of one drive: what it reports itself, and what is missing from it.
namespace boresight {

inline constexpr std::array kDriveAlarms{
    AlarmEntry{
        .id = "drive.fault",
        .source = "%1 drive",
        .severity = Severity::Alarm,
        .what = QT_TRANSLATE_NOOP("Text", "The %1 reports fault %2: %3"),
        .action = QT_TRANSLATE_NOOP("Text", "The drive switched its output off. The other axis holds if its drive can"),
        .remedy = "%4",
        .brief = QT_TRANSLATE_NOOP("Text", "fault %2: %3"),
        .help = AlarmHelp::Rearm,
        .kin = AlarmKin::Drive,
        .examples = {"azimuth drive", "35", "The port of the encoder reports an error",
                     "Likely cause: a wire is broken. Check the wiring of the encoder. Then press Re-arm"}},
    AlarmEntry{
        .id = "drive.fault-unnamed",
        .source = "%1 drive",
        .severity = Severity::Alarm,
        .what = QT_TRANSLATE_NOOP("Text", "The %1 is in fault without a fault code"),
        .action = QT_TRANSLATE_NOOP("Text", "The drive switched its output off. The other axis holds if its drive can"),
        .remedy = QT_TRANSLATE_NOOP("Text", "Read its fault with boresightctl scan."),
        .brief = QT_TRANSLATE_NOOP("Text", "in fault without a fault code"),
        .thenRearm = true,
        .help = AlarmHelp::Rearm,
        .kin = AlarmKin::Drive,
        .examples = {"azimuth drive"},
        .placeOf = "drive.fault"},
    AlarmEntry{
        .id = "drive.timed-out",
        .source = "%1 drive",
        .severity = Severity::Alarm,
        .what = QT_TRANSLATE_NOOP("Text", "The %1 timed out because it received no command in time"),
        .action = QT_TRANSLATE_NOOP("Text", "The watchdog stopped the drive. Boresight ended the motion of the mount"),
        .remedy = QT_TRANSLATE_NOOP("Text", "Check the bus and the load of this computer."),
        .thenRearm = true,
        .help = AlarmHelp::Rearm,
        .kin = AlarmKin::Drive,
        .examples = {"azimuth drive"},
        .placeOf = "drive.fault"},
    AlarmEntry{
        .id = "drive.switched-off",
        .source = "%1 drive",
        .severity = Severity::Alarm,
        .what = QT_TRANSLATE_NOOP("Text", "The %1 switched itself off"),
        .action = QT_TRANSLATE_NOOP("Text", "Boresight ended the motion. Each axis holds if its drive still can"),
        .remedy = QT_TRANSLATE_NOOP("Text", "Check its supply. Look for another program that stopped the drive."),
        .thenRearm = true,
        .help = AlarmHelp::Rearm,
        .kin = AlarmKin::Drive,
        .examples = {"azimuth drive"},
        .placeOf = "drive.fault"},
    AlarmEntry{.id = "drive.no-position",
               .source = "%1 drive",
               .severity = Severity::Alarm,
               .what = QT_TRANSLATE_NOOP("Text", "The %1 reports no credible position"),
               .action = QT_TRANSLATE_NOOP(
                   "Text", "Boresight ended the motion of the mount and commanded this drive to brake and hold"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Check its encoder and the CAN cable."),
               .thenRearm = true,
               .help = AlarmHelp::Rearm,
               .kin = AlarmKin::Drive,
               .examples = {"azimuth drive"},
               .placeOf = "drive.fault"},
    AlarmEntry{.id = "drive.disobeys",
               .source = "%1 drive",
               .severity = Severity::Alarm,
               .what = QT_TRANSLATE_NOOP("Text", "The %1 answers but does not follow its commands"),
               .action = QT_TRANSLATE_NOOP(
                   "Text", "Boresight sends no more motion commands. The other axis holds if its drive can"),
               .remedy = QT_TRANSLATE_NOOP(
                   "Text", "Check its mode and fault. Look for another program that commands the drive."),
               .thenRearm = true,
               .help = AlarmHelp::Rearm,
               .kin = AlarmKin::Drive,
               .examples = {"azimuth drive"},
               .placeOf = "drive.fault"},
    AlarmEntry{
        .id = "drive.silent",
        .source = "%1 drive",
        .severity = Severity::Alarm,
        .what = QT_TRANSLATE_NOOP("Text", "The %1 does not reply"),
        .action = QT_TRANSLATE_NOOP(
            "Text", "Boresight ended the motion. If the drive has power, its watchdog brakes it after %2 s"),
        .remedy = "%3",
        .help = AlarmHelp::Rearm,
        .kin = AlarmKin::Silence,
        .examples = {"azimuth drive", "0.2", "Check the supply, the CAN cable and the adapter. Then press Re-arm"}},
    AlarmEntry{
        .id = "drive.no-reply",
        .source = "%1 drive",
        .severity = Severity::Alarm,
        .what = QT_TRANSLATE_NOOP("Text", "The %1 does not reply"),
        .action = QT_TRANSLATE_NOOP("Text", "Boresight sends no motion commands"),
        .remedy = "%2",
        .help = AlarmHelp::OpenDrives,
        .kin = AlarmKin::Silence,
        .examples =
            {"azimuth drive",
             "Check the supply, the CAN cable, the adapter and the id of the drive. The page Drives lists the drives"},
        .placeOf = "drive.silent"},
    AlarmEntry{.id = "drive.answers-again",
               .source = "%1 drive",
               .severity = Severity::Alarm,
               .what = QT_TRANSLATE_NOOP("Text", "The %1 was silent and is back"),
               .action = QT_TRANSLATE_NOOP("Text", "Boresight ended the motion. Nothing moves before a re-arm"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Look for a loose plug, a worn cable or a weak supply."),
               .thenRearm = true,
               .help = AlarmHelp::Rearm,
               .kin = AlarmKin::Silence,
               .examples = {"azimuth drive"},
               .placeOf = "drive.silent"},
    AlarmEntry{
        .id = "drive.limit",
        .source = "%1 drive",
        .severity = Severity::Warning,
        .what = QT_TRANSLATE_NOOP("Text", "The %1 reports limit %2: %3"),
        .action = QT_TRANSLATE_NOOP("Text", "The drive gives less than Boresight commands"),
        .remedy = "%4",
        .brief = QT_TRANSLATE_NOOP("Text", "limit %2: %3"),
        .examples =
            {"azimuth drive", "99", "Limited by servo.max_current_A",
             "Likely cause: wind, friction, a blocked axis or a high acceleration. It ends when the demand falls"}},
    AlarmEntry{
        .id = "drive.active-unordered",
        .source = "%1 drive",
        .severity = Severity::Warning,
        .what = QT_TRANSLATE_NOOP("Text", "The %1 is active (mode: %2) without a command from Boresight"),
        .action = QT_TRANSLATE_NOOP(
            "Text", "Boresight leaves it alone until the first motion. STOP takes it over and holds it"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text", "End the other program that commands the drive. An old command without a watchdog ends with STOP"),
        .examples = {"azimuth drive", "position"}},
    AlarmEntry{
        .id = "drive.wrap-unknown",
        .source = "%1 drive",
        .severity = Severity::Warning,
        .what = QT_TRANSLATE_NOOP("Text", "The cable wrap of the %1 is unknown"),
        .action = QT_TRANSLATE_NOOP("Text", "Pointing is blocked and clients get no position. Slow jog still works"),
        .remedy = QT_TRANSLATE_NOOP("Text", "Look at the mount and its cable. Then enter the position of the axis"),
        .help = AlarmHelp::ConfirmWrap,
        .examples = {"azimuth drive"}},
    AlarmEntry{.id = "drive.place-unused",
               .source = "%1 drive",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP("Text", "Boresight did not use --standing-at for the %1: %2"),
               .action = QT_TRANSLATE_NOOP("Text", "The cable wrap stays unknown"),
               .remedy = QT_TRANSLATE_NOOP("Text",
                                           "Enter the position of the axis in the window. Without a window, restart "
                                           "with the present position and time"),
               .help = AlarmHelp::ConfirmWrap,
               .examples = {"azimuth drive", "the drive was switched off since"}},
};

}  // namespace boresight
