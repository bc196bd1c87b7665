// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_entry.h"

#include <QCoreApplication>

#include <array>

// The alarms about what Boresight itself sees going wrong on an axis. Its supervision says what happened, with the
// numbers. What only warns at first may stop the mount later: that is an alarm of its own, in the place of the warning.
namespace boresight {

inline constexpr std::array kAxisAlarms{
    AlarmEntry{.id = "axis.following-error",
               .source = "%1",
               .severity = Severity::Warning,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "Boresight does not stop the mount"),
               .remedy = QT_TRANSLATE_NOOP(
                   "Text", "Look for wind, ice or a tight cable. Otherwise lower the acceleration or check the gains."),
               .examples = {"the azimuth is 1.2° away from its set-point for 0.50 s"}},
    AlarmEntry{.id = "axis.following-error.stop",
               .source = "%1",
               .severity = Severity::Alarm,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "Boresight stopped the mount and holds it"),
               .remedy = QT_TRANSLATE_NOOP(
                   "Text", "Look for wind, ice or a tight cable. Otherwise lower the acceleration or check the gains."),
               .thenRearm = true,
               .examples = {"the azimuth is 3.5° away from its set-point for 0.50 s"},
               .placeOf = "axis.following-error"},
    AlarmEntry{.id = "axis.stalled",
               .source = "%1",
               .severity = Severity::Alarm,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "Boresight stopped the mount and holds it"),
               .remedy = QT_TRANSLATE_NOOP(
                   "Text", "Look for a cable, a lock, ice or a slipping coupling that blocks the axis, and free it."),
               .thenRearm = true,
               .examples = {"the azimuth does not move: 2.4° at 3.0°/s commanded in 0.80 s, 0.1° moved"}},
    AlarmEntry{.id = "axis.wrong-way",
               .source = "%1",
               .severity = Severity::Alarm,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "Boresight stopped the mount and holds it"),
               .remedy = QT_TRANSLATE_NOOP(
                   "Text", "Calibrate the motor again and check its phases and the encoder before you re-arm."),
               .examples = {"the azimuth moves the wrong way: 2.4° at 3.0°/s commanded in 0.80 s, -0.6° moved"}},
    AlarmEntry{
        .id = "axis.moves-uncommanded",
        .source = "%1",
        .severity = Severity::Warning,
        .what = "%1",
        .action = QT_TRANSLATE_NOOP("Text", "Boresight does not stop the mount"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text",
            "Look for wind, a person at the antenna or a slipping gear. Secure the axis, then check the position."),
        .examples = {"the azimuth moved by 1.2° to 31.2° without a command (weight, wind, a hand or another program)"}},
    AlarmEntry{
        .id = "axis.moves-uncommanded.stop",
        .source = "%1",
        .severity = Severity::Alarm,
        .what = "%1",
        .action = QT_TRANSLATE_NOOP("Text", "Boresight stopped the mount and holds it"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text",
            "Look for wind, a person at the antenna or a slipping gear. Secure the axis, then check the position."),
        .thenRearm = true,
        .examples = {"the azimuth moved by 1.2° to 31.2° although it has to hold its position"},
        .placeOf = "axis.moves-uncommanded"},
    AlarmEntry{
        .id = "axis.encoder-jump",
        .source = "%1",
        .severity = Severity::Warning,
        .what = "%1",
        .action = QT_TRANSLATE_NOOP("Text", "Boresight does not stop the mount"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text", "Compare the shown angle with the antenna. Check encoder, wiring and other programs on the bus."),
        .examples = {"a false reply reported a jump of the azimuth by 40.0° in 0.02 s to 71.2°"}},
    AlarmEntry{
        .id = "axis.encoder-jump.stop",
        .source = "%1",
        .severity = Severity::Alarm,
        .what = "%1",
        .action = QT_TRANSLATE_NOOP("Text", "Boresight stopped the mount and holds it"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text", "Compare the shown angle with the antenna. Check encoder, wiring and other programs on the bus."),
        .thenRearm = true,
        .examples =
            {"the reported angle of the azimuth jumped by 40.0° in 0.02 s to 71.2°, faster than the axis can move"},
        .placeOf = "axis.encoder-jump"},
    AlarmEntry{.id = "axis.outside-travel",
               .source = "%1",
               .severity = Severity::Warning,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "Boresight does not stop the mount"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Jog the axis back inside while you watch the cable."),
               .examples = {"the azimuth is at 451.0°, 1.0° beyond its travel -90.0°…450.0°"}},
    AlarmEntry{.id = "axis.outside-travel.stop",
               .source = "%1",
               .severity = Severity::Alarm,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "Boresight stopped the mount and holds it"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Jog the axis back inside while you watch the cable."),
               .thenRearm = true,
               .examples = {"the azimuth is at 452.0°, 2.0° beyond its travel -90.0°…450.0°, and moves farther out"},
               .placeOf = "axis.outside-travel"},
    AlarmEntry{.id = "axis.replies-late",
               .source = "%1",
               .severity = Severity::Advisory,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "Boresight does not stop the mount"),
               .remedy = QT_TRANSLATE_NOOP(
                   "Text", "Check the load of the bus and of this computer, the cable and the termination."),
               .examples = {"a reply of the azimuth drive came 0.12 s after the one before"}},
    AlarmEntry{.id = "axis.supply-low",
               .source = "%1",
               .severity = Severity::Warning,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "Boresight does not stop the mount"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Check supply, battery and cable, or lower the acceleration."),
               .examples = {"the supply of the azimuth is at 20.5 V, below 21.0 V"}},
    AlarmEntry{.id = "axis.supply-low.stop",
               .source = "%1",
               .severity = Severity::Alarm,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "Boresight stopped the mount and holds it"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Check supply, battery and cable, or lower the acceleration."),
               .thenRearm = true,
               .examples = {"the supply of the azimuth is at 17.5 V, below 18.0 V"},
               .placeOf = "axis.supply-low"},
    AlarmEntry{
        .id = "axis.supply-high",
        .source = "%1",
        .severity = Severity::Warning,
        .what = "%1",
        .action = QT_TRANSLATE_NOOP("Text", "Boresight does not stop the mount"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text", "Lower the acceleration, set servo.max_regen_power_W, or add a battery or a brake resistor."),
        .examples = {"the supply of the azimuth is at 29.0 V, above 28.0 V"}},
    AlarmEntry{.id = "axis.board-hot",
               .source = "%1",
               .severity = Severity::Warning,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "Boresight does not stop the mount"),
               .remedy = QT_TRANSLATE_NOOP(
                   "Text", "Cool and shade the board, or move less. At its limit the drive releases the axis."),
               .examples = {"the drive board of the azimuth is at 71 °C"}},
    AlarmEntry{
        .id = "axis.motor-hot",
        .source = "%1",
        .severity = Severity::Warning,
        .what = "%1",
        .action = QT_TRANSLATE_NOOP("Text", "Boresight does not stop the mount"),
        .remedy = QT_TRANSLATE_NOOP("Text", "Let the motor cool down. Look for friction or a load out of balance."),
        .examples = {"the motor of the azimuth is at 81 °C"}},
    AlarmEntry{.id = "axis.torque-high",
               .source = "%1",
               .severity = Severity::Warning,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "Boresight does not stop the mount"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Look for wind, ice, friction or a load out of balance."),
               .examples = {"the azimuth needs 12.0 Nm, 80 % of the 15.0 Nm allowed"}},
    AlarmEntry{.id = "axis.torque-guard",
               .source = "%1",
               .severity = Severity::Alarm,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "Boresight stopped the mount and holds it"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Check whether a cable is wound up, and jog the other way."),
               .thenRearm = true,
               .examples = {"the azimuth needs 6.0 Nm, 40 % of the 15.0 Nm allowed, while its cable wrap is unknown"}},
};

}  // namespace boresight
