// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_entry.h"

#include <QCoreApplication>

#include <array>

// The alarms of a rotator with its own control box: its line, its answers, and whether it carries out commands.
namespace boresight {

inline constexpr std::array kRotatorAlarms{
    AlarmEntry{.id = "rotator.line-down",
               .source = "rotator",
               .severity = Severity::Alarm,
               .what = QT_TRANSLATE_NOOP("Text", "The line to the rotator is down: %1"),
               .action = QT_TRANSLATE_NOOP(
                   "Text", "Boresight can command nothing. It tries to open the line again each second"),
               .remedy = QT_TRANSLATE_NOOP(
                   "Text",
                   "Check the cable and the box. If the port is wrong, choose another one on the page Profile "
                   "(bus.name)"),
               .brief = "%1",
               .help = AlarmHelp::OpenProfile,
               .kin = AlarmKin::BusGone,
               .examples = {"/dev/ttyUSB0 is in use by rotctld (process 1234). End that program first"}},
    AlarmEntry{
        .id = "rotator.foreign",
        .source = "rotator",
        .severity = Severity::Alarm,
        .what = QT_TRANSLATE_NOOP("Text", "The device on %1 is not %2. It sent \"%3\""),
        .action = QT_TRANSLATE_NOOP("Text", "Boresight closed the line, and sends nothing more"),
        .remedy = QT_TRANSLATE_NOOP("Text", "Check the port and the speed (bus.name, bus.baud). Then press Reconnect"),
        .help = AlarmHelp::Reconnect,
        .kin = AlarmKin::BusGone,
        .examples = {"serial:/dev/ttyUSB0", "a GS-232 rotator", "IF00014250000"},
        .placeOf = "rotator.line-down"},
    AlarmEntry{
        .id = "rotator.no-answer",
        .source = "rotator",
        .severity = Severity::Alarm,
        .what = QT_TRANSLATE_NOOP("Text", "The rotator does not answer"),
        .action = QT_TRANSLATE_NOOP("Text", "Boresight keeps asking for its position. It sends no motion commands"),
        .remedy = "%1",
        .help = AlarmHelp::OpenProfile,
        .kin = AlarmKin::Silence,
        .examples = {"Check the power of the rotator, the cable, and the speed (bus.baud, 9600)"},
        .identifying = 0},
    AlarmEntry{.id = "rotator.silent",
               .source = "rotator",
               .severity = Severity::Alarm,
               .what = QT_TRANSLATE_NOOP("Text", "The rotator fell silent in motion"),
               .action = QT_TRANSLATE_NOOP("Text",
                                           "Boresight sent a stop, and sends another stop as soon as an answer comes. "
                                           "Until then the rotator may run to its last target"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Look at the mount. Check the power of the box and the cable."),
               .thenRearm = true,
               .help = AlarmHelp::Rearm,
               .kin = AlarmKin::Silence,
               .placeOf = "rotator.no-answer"},
    AlarmEntry{.id = "rotator.stuck",
               .source = "%1",
               .severity = Severity::Alarm,
               .what = QT_TRANSLATE_NOOP("Text", "The %1 stands at %2 although it was sent to %3 twice"),
               .action = QT_TRANSLATE_NOOP("Text", "Boresight sent a stop and ended the motion"),
               .remedy = QT_TRANSLATE_NOOP(
                   "Text", "Look for a blocked axis, a motor without power, or a box that was switched to manual."),
               .thenRearm = true,
               .help = AlarmHelp::Rearm,
               .kin = AlarmKin::Drive,
               .examples = {"azimuth drive", "34°", "60°"},
               .identifying = 1},
    AlarmEntry{.id = "rotator.jumped",
               .source = "%1",
               .severity = Severity::Alarm,
               .what = QT_TRANSLATE_NOOP("Text", "The position of the %1 jumped from %2 to %3"),
               .action = QT_TRANSLATE_NOOP("Text", "Boresight sent a stop and ended the motion"),
               .remedy = QT_TRANSLATE_NOOP(
                   "Text", "Compare the position with the mount and its cable. Calibrate the box if it is wrong."),
               .thenRearm = true,
               .help = AlarmHelp::Rearm,
               .kin = AlarmKin::Drive,
               .examples = {"azimuth drive", "34°", "394°"},
               .identifying = 1,
               .placeOf = "rotator.stuck"},
    AlarmEntry{.id = "rotator.refused",
               .source = "rotator",
               .severity = Severity::Alarm,
               .what = QT_TRANSLATE_NOOP("Text", "The rotator refused its target: %1"),
               .action = QT_TRANSLATE_NOOP("Text", "Boresight sent a stop and ended the motion"),
               .remedy = QT_TRANSLATE_NOOP("Text",
                                           "Compare the travel of the profile with the limits of the rotator, and "
                                           "check its power."),
               .thenRearm = true,
               .help = AlarmHelp::Rearm,
               .kin = AlarmKin::Drive,
               .examples = {"the position is outside the limits of rotctld (RPRT -21)"}},
    AlarmEntry{.id = "rotator.runs-on",
               .source = "%1",
               .severity = Severity::Alarm,
               .what = QT_TRANSLATE_NOOP("Text", "The %1 still turns after several stops"),
               .action = QT_TRANSLATE_NOOP("Text", "Boresight repeats the stop each second"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Switch the rotator off at its box."),
               .thenRearm = true,
               .help = AlarmHelp::Rearm,
               .kin = AlarmKin::Drive,
               .examples = {"azimuth drive"},
               .placeOf = "rotator.stuck"},
    AlarmEntry{
        .id = "rotator.spared",
        .source = "%1",
        .severity = Severity::Warning,
        .what = QT_TRANSLATE_NOOP("Text", "The %1 is %2 away from its target, more than half the beam width"),
        .action = QT_TRANSLATE_NOOP("Text", "Boresight waits, because the motor may start only %3 times a minute"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text", "Permit more starts on the page Profile (rotator.max_starts_per_min), or point less exactly."),
        .help = AlarmHelp::OpenProfile,
        .examples = {"azimuth drive", "7°", "4"},
        .identifying = 1},
    AlarmEntry{
        .id = "rotator.home-run",
        .source = "rotator",
        .severity = Severity::Warning,
        .what = QT_TRANSLATE_NOOP("Text", "The rotator makes its home run"),
        .action = QT_TRANSLATE_NOOP(
            "Text", "The box drives the axes to its own switches. The limits of Boresight do not hold meanwhile"),
        .remedy = QT_TRANSLATE_NOOP("Text", "Watch the antenna and its cable. STOP ends the run.")},
    AlarmEntry{
        .id = "rotator.no-home-run",
        .source = "rotator",
        .severity = Severity::Warning,
        .what = QT_TRANSLATE_NOOP("Text", "The home run failed: %1"),
        .action = QT_TRANSLATE_NOOP("Text", "Boresight ended it. The count of the axes is as it was"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text", "Make the home run at the box, if the box has one. Then compare the angles with the antenna."),
        .examples = {"the rotator does not have this function"}},
    AlarmEntry{
        .id = "rotator.offsets",
        .source = "rotator",
        .severity = Severity::Warning,
        .what = QT_TRANSLATE_NOOP("Text", "The sensor of the rotator has other offsets than those saved"),
        .action = QT_TRANSLATE_NOOP("Text", "Boresight cannot write them to the box, and uses its angles unchanged"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text",
            "Point at a known direction. If the antenna misses it, find north again. Then press Save offsets on the "
            "page Console, which shows both."),
        .help = AlarmHelp::OpenNorth},
};

}  // namespace boresight
