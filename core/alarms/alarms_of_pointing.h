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
               .what = QT_TRANSLATE_NOOP("Text", "No data from the orientation sensor (%1)"),
               .action = QT_TRANSLATE_NOOP("Text", "Pointing continues, because the sensor is only a cross-check"),
               .remedy = "%2",
               .examples = {"mqtt sensor/orientation", "Check its power, WiFi and cable"}},
    AlarmEntry{.id = "sensor.dead",
               .source = "sensor",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP("Text", "The orientation sensor sends only zeros"),
               .action = QT_TRANSLATE_NOOP("Text", "Pointing continues, because the sensor is only a cross-check"),
               .remedy = QT_TRANSLATE_NOOP(
                   "Text", "Check the wires between its BNO055 and its board, then switch it off and on"),
               .placeOf = "sensor.silent"},
    AlarmEntry{.id = "sensor.disagrees-azimuth",
               .source = "sensor",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP("Text", "The orientation sensor and the axes differ by %1 in azimuth"),
               .action = QT_TRANSLATE_NOOP("Text", "Pointing is unchanged, because the sensor is only a cross-check"),
               .remedy = "%2",
               .examples =
                   {"12.3°",
                    "Check the azimuth offset and mounting of the sensor, iron near the compass and the azimuth zero"}},
    AlarmEntry{
        .id = "sensor.disagrees-elevation",
        .source = "sensor",
        .severity = Severity::Warning,
        .what = QT_TRANSLATE_NOOP("Text", "The orientation sensor and the axes differ by %1 in elevation"),
        .action = QT_TRANSLATE_NOOP("Text", "Pointing is unchanged, because the sensor is only a cross-check"),
        .remedy = "%2",
        .examples = {"4.5°",
                     "Check the elevation offset and mounting of the sensor, the elevation zero and the coupling"},
        .placeOf = "sensor.disagrees-azimuth"},
    AlarmEntry{
        .id = "north.not-set",
        .source = "north",
        .severity = Severity::Advisory,
        .what = QT_TRANSLATE_NOOP("Text",
                                  "North is not set, and the orientation sensor and the axes differ by %1 in azimuth"),
        .action = QT_TRANSLATE_NOOP("Text", "Pointing is unchanged. Until north is set, azimuths are axis angles"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text", "Find north (panel North, Ctrl+9). If the axis zero is north, check sensor mounting and coupling"),
        .examples = {"40.3°"}},
    AlarmEntry{
        .id = "sun.near",
        .source = "Sun",
        .severity = Severity::Warning,
        .what = QT_TRANSLATE_NOOP("Text", "The beam is less than %1° from the Sun"),
        .action = QT_TRANSLATE_NOOP("Text", "Boresight starts no motion and allows only motions away from the Sun"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text", "Move the mount away or let the Sun pass. The setting keep_away (Sun) turns this off"),
        .examples = {"5.0"}},
    AlarmEntry{
        .id = "sun.near-one-axis",
        .source = "Sun",
        .severity = Severity::Advisory,  // nobody knows that it is near, and without an azimuth it lasts for hours
        .what = QT_TRANSLATE_NOOP("Text",
                                  "The beam may be less than %1° from the Sun, because the mount has only one axis"),
        .action = QT_TRANSLATE_NOOP("Text", "Boresight starts no motion and allows only motions away from the Sun"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text", "Move the mount away or let the Sun pass. The setting keep_away (Sun) turns this off"),
        .examples = {"5.0"},
        .placeOf = "sun.near"},
    AlarmEntry{.id = "sun.clock",
               .source = "Sun",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP(
                   "Text", "The clock of this computer is not synchronised, so the position of the Sun is unknown"),
               .action = QT_TRANSLATE_NOOP("Text", "Boresight refuses motions to every position that the Sun can have"),
               .remedy = QT_TRANSLATE_NOOP(
                   "Text", "Synchronise the clock by NTP or GPS. If its time is right, set clock (Sun) to trusted")},
    AlarmEntry{
        .id = "sun.followed",
        .source = "calibration",
        .severity = Severity::Warning,
        .what = QT_TRANSLATE_NOOP("Text", "the antenna points at the Sun, or moves to it"),
        .action = "%1",
        .remedy = QT_TRANSLATE_NOOP(
            "Text",
            "Never look along the beam or a sight tube without a solar filter. Protect a dish feed from the heat"),
        .examples = {"The mount tracks the Sun until you command another motion"}},
    AlarmEntry{.id = "swing.waits",
               .source = "calibration",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP("Text", "the compass swing waits for its sensor"),
               .action = QT_TRANSLATE_NOOP(
                   "Text", "The mount stands still. It continues BY ITSELF when sensor data returns within %1 s"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Keep clear of the mount. STOP or Hold ends the swing"),
               .examples = {"30"}},
    AlarmEntry{.id = "calibration.other-mount",
               .source = "calibration",
               .severity = Severity::Warning,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "The model stays in force. Boresight moves nothing"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Find north again and apply it, or undo the calibration"),
               .examples = {"The pointing model in force (\"Sun\", 2026-11-21) was applied with another drive"}},
    AlarmEntry{
        .id = "calibration.not-stored",
        .source = "calibration",
        .severity = Severity::Warning,
        .what = "%1",
        .action = QT_TRANSLATE_NOOP("Text", "The calibration is in force. Boresight keeps its history in memory only"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text", "Check the disk or choose another --state-dir. After a restart Undo is not possible"),
        .examples = {"cannot write calibrations.toml: no space left on device"}},
    AlarmEntry{
        .id = "points.other-drive",
        .source = "calibration",
        .severity = Severity::Warning,
        .what = QT_TRANSLATE_NOOP("Text", "the points on the page Sun/Moon were taken with another drive"),
        .action = QT_TRANSLATE_NOOP("Text", "Boresight no longer uses any of them"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text", "Drop them and take new ones. On the page Model you can use a point again that is still right")},
    AlarmEntry{
        .id = "points.other-site",
        .source = "calibration",
        .severity = Severity::Warning,
        .what = QT_TRANSLATE_NOOP("Text", "the points on the page Sun/Moon were taken at another site"),
        .action = QT_TRANSLATE_NOOP("Text", "Boresight no longer uses any of them"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text", "Drop them and take new ones. On the page Model you can use a point again that is still right"),
        .placeOf = "points.other-drive"},
};

}  // namespace boresight
