// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_entry.h"

#include <QCoreApplication>

#include <array>

// The alarms about where the beam points: the independent sensor, the Sun, north and its calibration.
namespace boresight {

inline constexpr std::array kPointingAlarms{
    AlarmEntry{.id = "sensor.silent",
               .source = "sensor",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP("Text", "Nothing is heard of the orientation sensor (%1)"),
               .action = QT_TRANSLATE_NOOP("Text", "Pointing goes on without it: it is only a witness"),
               .remedy = "%2",
               .examples = {"mqtt sensor/orientation", "Check its power, its WiFi and its cable"}},
    AlarmEntry{.id = "sensor.dead",
               .source = "sensor",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP("Text", "The orientation sensor sends nothing but zeros"),
               .action = QT_TRANSLATE_NOOP("Text", "Pointing goes on without it: it is only a witness"),
               .remedy = QT_TRANSLATE_NOOP(
                   "Text", "Its BNO055 does not answer its board: check their wires, then switch it off and on"),
               .placeOf = "sensor.silent"},
    AlarmEntry{.id = "sensor.disagrees-azimuth",
               .source = "sensor",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP("Text", "The orientation sensor and the axes differ by %1 in azimuth"),
               .action = QT_TRANSLATE_NOOP(
                   "Text", "Nothing is moved because of it: the encoders count, the sensor is only a witness"),
               .remedy = "%2",
               .examples = {"12.3°", "Likely: iron near the compass, or a coupling slips: look at the antenna"}},
    AlarmEntry{.id = "sensor.disagrees-elevation",
               .source = "sensor",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP("Text", "The orientation sensor and the axes differ by %1 in elevation"),
               .action = QT_TRANSLATE_NOOP(
                   "Text", "Nothing is moved because of it: the encoders count, the sensor is only a witness"),
               .remedy = "%2",
               .examples = {"4.5°", "Likely: the sensor has come loose, or a coupling slips: look at the antenna"},
               .placeOf = "sensor.disagrees-azimuth"},
    AlarmEntry{
        .id = "north.not-set",
        .source = "north",
        .severity = Severity::Advisory,
        .what = QT_TRANSLATE_NOOP(
            "Text", "No north is set in the profile, and the orientation sensor and the axes differ by %1 in azimuth"),
        .action = QT_TRANSLATE_NOOP("Text", "Nothing is moved because of it: azimuths are those of the axis"),
        .remedy =
            QT_TRANSLATE_NOOP("Text",
                              "Find north: panel North (Ctrl+9). If the zero of the axis was set to north already, "
                              "likely: the sensor has an offset of its own or was shifted, or a coupling slips"),
        .examples = {"40.3°"}},
    AlarmEntry{.id = "sun.near",
               .source = "Sun",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP("Text", "The beam is less than %1° from the Sun"),
               .action = QT_TRANSLATE_NOOP("Text", "Nothing moves by itself, and motions only lead out of there"),
               .remedy = QT_TRANSLATE_NOOP("Text",
                                           "Move the mount away, or let the Sun pass; sun.keep_away switches this off"),
               .examples = {"5.0"}},
    AlarmEntry{.id = "sun.clock",
               .source = "Sun",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP(
                   "Text", "The clock of this computer is not synchronised, so the place of the Sun is unknown"),
               .action = QT_TRANSLATE_NOOP("Text", "Boresight refuses motions to every place that the Sun can have"),
               .remedy = QT_TRANSLATE_NOOP(
                   "Text", "Synchronise the clock by NTP or GPS. If its time is right, set sun.clock to trusted")},
    AlarmEntry{.id = "sun.followed",
               .source = "calibration",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP("Text", "the beam is at the Sun, or led there"),
               .action = "%1",
               .remedy = QT_TRANSLATE_NOOP("Text",
                                           "Never look along the beam, nor through a sight tube without a solar "
                                           "filter; a dish gathers the Sun's heat in the feed: cover it, or be quick"),
               .examples = {"The mount follows the Sun until something else is asked of it"}},
    AlarmEntry{.id = "swing.waits",
               .source = "calibration",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP("Text", "the swing of the compass waits for its sensor"),
               .action = QT_TRANSLATE_NOOP(
                   "Text", "The mount stands still and goes on BY ITSELF when the sensor is heard within %1 s"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Keep clear of the mount; STOP or Hold ends the swing"),
               .examples = {"30"}},
    AlarmEntry{.id = "calibration.other-mount",
               .source = "calibration",
               .severity = Severity::Warning,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "It stays in force; nothing moves"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Find north anew and apply it, or take the calibration back"),
               .examples = {"The pointing model in force (\"Sun\", 2026-11-21) was applied with another drive"}},
    AlarmEntry{.id = "calibration.not-stored",
               .source = "calibration",
               .severity = Severity::Warning,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "What is applied is in force; its history is kept in memory only"),
               .remedy = QT_TRANSLATE_NOOP("Text",
                                           "Check the disk, or choose another folder with --state-dir; else it cannot "
                                           "be taken back after the program was ended"),
               .examples = {"cannot write calibrations.toml: no space left on device"}},
    AlarmEntry{
        .id = "points.other-drive",
        .source = "calibration",
        .severity = Severity::Warning,
        .what = QT_TRANSLATE_NOOP("Text", "the points on the page Sun/Moon were taken with another drive"),
        .action = QT_TRANSLATE_NOOP("Text", "None of them is used any more: nothing is found from them"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text", "Drop them and take new ones; a point that still holds can be used again on the page Model")},
    AlarmEntry{.id = "points.other-site",
               .source = "calibration",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP("Text", "the points on the page Sun/Moon were taken at another site"),
               .action = QT_TRANSLATE_NOOP("Text", "None of them is used any more: nothing is found from them"),
               .remedy = QT_TRANSLATE_NOOP(
                   "Text", "Drop them and take new ones; a point that still holds can be used again on the page Model"),
               .placeOf = "points.other-drive"},
};

}  // namespace boresight
