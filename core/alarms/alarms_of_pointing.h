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
               .what = QT_TRANSLATE_NOOP("Text", "The orientation sensor (%1) sends no data"),
               .action = QT_TRANSLATE_NOOP("Text", "Pointing continues, because the sensor is only a cross-check"),
               .remedy = "%2",
               .examples = {"mqtt sensor/orientation", "Check its power, WiFi and cable"}},
    AlarmEntry{.id = "sensor.dead",
               .source = "sensor",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP("Text", "The orientation sensor sends only zeros"),
               .action = QT_TRANSLATE_NOOP("Text", "Pointing continues, because the sensor is only a cross-check"),
               .remedy = QT_TRANSLATE_NOOP(
                   "Text", "Check the wires between its BNO055 and its board. Then switch the sensor off and on"),
               .placeOf = "sensor.silent"},
    AlarmEntry{
        .id = "sensor.disagrees-azimuth",
        .source = "sensor",
        .severity = Severity::Warning,
        .what = QT_TRANSLATE_NOOP("Text", "The orientation sensor and the axes differ by %1 in azimuth"),
        .action = QT_TRANSLATE_NOOP("Text", "Pointing is unchanged, because the sensor is only a cross-check"),
        .remedy = "%2",
        .help = AlarmHelp::OpenNorth,
        .examples =
            {"12.3°",
             "Check the azimuth offset and mounting of the sensor, iron or a motor current near the compass, and the "
             "azimuth zero"},
        .identifying = 0},
    AlarmEntry{
        .id = "sensor.disagrees-elevation",
        .source = "sensor",
        .severity = Severity::Warning,
        .what = QT_TRANSLATE_NOOP("Text", "The orientation sensor and the axes differ by %1 in elevation"),
        .action = QT_TRANSLATE_NOOP("Text", "Pointing is unchanged, because the sensor is only a cross-check"),
        .remedy = "%2",
        .help = AlarmHelp::OpenNorth,
        .examples = {"4.5°",
                     "Check the elevation offset and mounting of the sensor, the elevation zero and the coupling"},
        .identifying = 0,
        .placeOf = "sensor.disagrees-azimuth"},
    AlarmEntry{
        .id = "north.not-set",
        .source = "north",
        .severity = Severity::Advisory,
        .what =
            QT_TRANSLATE_NOOP("Text", "North is not set: the orientation sensor and the axes differ by %1 in azimuth"),
        .action = QT_TRANSLATE_NOOP("Text", "Pointing is unchanged. Until north is set, azimuths are axis angles"),
        .remedy = QT_TRANSLATE_NOOP("Text",
                                    "Find north on the page North. If the axis zero is north, check the mounting of "
                                    "the sensor and the coupling"),
        .help = AlarmHelp::OpenNorth,
        .examples = {"40.3°"},
        .identifying = 0},
    AlarmEntry{
        .id = "limits.outside",
        .source = "station",
        .severity = Severity::Warning,
        .what = QT_TRANSLATE_NOOP("Text", "The antenna stands in a forbidden direction: %1"),
        .action = QT_TRANSLATE_NOOP("Text", "Boresight allows only motions that lead out. It starts none by itself"),
        .remedy = QT_TRANSLATE_NOOP("Text", "Move the antenna out on the page Jog, or change the limits"),
        .help = AlarmHelp::OpenLimits,
        .examples = {"the keep-out \"mast\""}},
    AlarmEntry{.id = "schedule.disarmed",
               .source = "schedule",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP("Text", "The schedule of passes is off: %1"),
               .action = QT_TRANSLATE_NOOP("Text", "Boresight begins no further pass by itself"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Arm the schedule again when the mount may move by itself"),
               .examples = {"the operator pressed STOP"}},
    AlarmEntry{.id = "track.no-orbit",
               .source = "station",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP("Text", "The orbit of %1 cannot be computed any more: %2"),
               .action = QT_TRANSLATE_NOOP("Text", "Boresight ended the tracking. The mount holds"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Load newer elements of the satellite, then track it again"),
               .examples = {"ISS (ZARYA)", "it has decayed"}},
    AlarmEntry{
        .id = "track.clock",
        .source = "station",
        .severity = Severity::Warning,
        .what = QT_TRANSLATE_NOOP("Text", "The clock of this computer is not synchronised, so the beam may miss %1"),
        .action = QT_TRANSLATE_NOOP("Text", "Boresight tracks by this clock"),
        .remedy = QT_TRANSLATE_NOOP("Text",
                                    "Synchronise the clock by NTP or GPS. A satellite 420 km up moves 1° in a second"),
        .examples = {"ISS (ZARYA)"}},
    AlarmEntry{.id = "azel.stale",
               .source = "azel.dat",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP("Text", "The Moon cannot be tracked by azel.dat: %1"),
               .action = QT_TRANSLATE_NOOP(
                   "Text", "The mount stands still. It moves again BY ITSELF if the file is right again before %2"),
               .remedy = QT_TRANSLATE_NOOP("Text", "STOP or Hold ends the tracking"),
               .examples = {"nothing writes the file: open the window Astronomical Data of WSJT-X", "17:06:10Z"},
               .identifying = 0},
    AlarmEntry{.id = "azel.ended",
               .source = "azel.dat",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP("Text", "The Moon is no longer tracked by azel.dat: %1"),
               .action = QT_TRANSLATE_NOOP("Text", "Boresight ended the tracking. The mount holds"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Check WSJT-X, then track the Moon again"),
               .examples = {"its Moon is 28.4° off: the locator in WSJT-X or the site is wrong"},
               .identifying = 0,
               .placeOf = "azel.stale"},
    AlarmEntry{.id = "azel.differs",
               .source = "azel.dat",
               .severity = Severity::Advisory,
               .what = QT_TRANSLATE_NOOP(
                   "Text", "The Moon of azel.dat is %1 away from the Moon that Boresight computes for the site"),
               .action = QT_TRANSLATE_NOOP("Text", "The mount follows the file, in its steps of 0.1°"),
               .remedy = QT_TRANSLATE_NOOP(
                   "Text", "Enter the same locator in WSJT-X and in the profile, with at least six characters"),
               .help = AlarmHelp::OpenProfile,
               .examples = {"0.7°"},
               .identifying = 0},
    AlarmEntry{
        .id = "sun.near",
        .source = "Sun",
        .severity = Severity::Warning,
        .what = QT_TRANSLATE_NOOP("Text", "The beam is less than %1° from the Sun"),
        .action = QT_TRANSLATE_NOOP("Text", "Boresight starts no motion and allows only motions away from the Sun"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text",
            "Move the mount away, or wait until the Sun has passed. The setting keep_away (Sun) turns this rule off"),
        .examples = {"5.0"}},
    AlarmEntry{
        .id = "sun.near-one-axis",
        .source = "Sun",
        .severity = Severity::Advisory,  // nobody knows that it is near, and without an azimuth it lasts for hours
        .what = QT_TRANSLATE_NOOP("Text",
                                  "The beam may be less than %1° from the Sun, because the mount has only one axis"),
        .action = QT_TRANSLATE_NOOP("Text", "Boresight starts no motion and allows only motions away from the Sun"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text",
            "Move the mount away, or wait until the Sun has passed. The setting keep_away (Sun) turns this rule off"),
        .examples = {"5.0"},
        .placeOf = "sun.near"},
    AlarmEntry{.id = "sun.clock",
               .source = "Sun",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP(
                   "Text", "The clock of this computer is not synchronised, so the position of the Sun is unknown"),
               .action = QT_TRANSLATE_NOOP("Text", "Boresight refuses motions to every position that the Sun can have"),
               .remedy = QT_TRANSLATE_NOOP("Text",
                                           "Synchronise the clock by NTP or GPS. If its time is right, set clock (Sun) "
                                           "to trusted on the page Profile"),
               .help = AlarmHelp::OpenProfile},
    AlarmEntry{.id = "sun.followed",
               .source = "calibration",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP("Text", "The antenna points at the Sun, or moves to it"),
               .action = "%1",
               .remedy = QT_TRANSLATE_NOOP("Text",
                                           "Never look along the beam or a sight tube without a solar filter. Protect "
                                           "the feed of a dish from the heat"),
               .examples = {"The mount tracks the Sun until you command another motion"}},
    AlarmEntry{.id = "swing.waits",
               .source = "calibration",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP("Text", "The compass swing waits for its sensor"),
               .action = QT_TRANSLATE_NOOP(
                   "Text", "The mount stands still. It moves again BY ITSELF if sensor data returns before %1"),
               .remedy = QT_TRANSLATE_NOOP("Text", "Keep clear of the mount. STOP or Hold ends the swing"),
               .help = AlarmHelp::OpenNorth,
               .examples = {"17:06:10Z"}},
    AlarmEntry{
        .id = "calibration.other-mount",
        .source = "calibration",
        .severity = Severity::Warning,
        .what = "%1",
        .action = QT_TRANSLATE_NOOP("Text", "The model stays in force. Boresight moves nothing because of this"),
        .remedy = QT_TRANSLATE_NOOP("Text", "Find north again on the page North and apply it, or undo the calibration"),
        .help = AlarmHelp::OpenNorth,
        .examples = {"The pointing model in force (\"Sun\", 2026-11-21) was applied with another drive"}},
    AlarmEntry{
        .id = "calibration.not-stored",
        .source = "calibration",
        .severity = Severity::Warning,
        .what = QT_TRANSLATE_NOOP("Text", "The history of the calibration is not stored: %1"),
        .action = QT_TRANSLATE_NOOP("Text", "The calibration is in force. Boresight keeps its history in memory only"),
        .remedy = QT_TRANSLATE_NOOP(
            "Text", "Check the disk, or choose another folder with --state-dir. After a restart Undo is not possible"),
        .brief = "%1",
        .examples = {"cannot write calibrations.toml: no space left on device"}},
    AlarmEntry{.id = "points.other-drive",
               .source = "calibration",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP("Text", "The points on the page Sun/Moon were taken with another drive"),
               .action = QT_TRANSLATE_NOOP("Text", "Boresight no longer uses any of them"),
               .remedy = QT_TRANSLATE_NOOP("Text",
                                           "Open the page North, drop the points and take new ones. On its page Model "
                                           "you can use a point again that is still right"),
               .help = AlarmHelp::OpenNorth},
    AlarmEntry{.id = "points.other-site",
               .source = "calibration",
               .severity = Severity::Warning,
               .what = QT_TRANSLATE_NOOP("Text", "The points on the page Sun/Moon were taken at another site"),
               .action = QT_TRANSLATE_NOOP("Text", "Boresight no longer uses any of them"),
               .remedy = QT_TRANSLATE_NOOP("Text",
                                           "Open the page North, drop the points and take new ones. On its page Model "
                                           "you can use a point again that is still right"),
               .help = AlarmHelp::OpenNorth,
               .placeOf = "points.other-drive"},
};

}  // namespace boresight
