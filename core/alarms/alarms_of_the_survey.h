// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_entry.h"

#include <QCoreApplication>

#include <array>

// The alarms about what the check of the drives finds on the bus and in their settings. The finding says what happened.
namespace boresight {

inline constexpr std::array kSurveyAlarms{
    AlarmEntry{
        .id = "drives.missing",
        .source = "drives",
        .severity = Severity::Alarm,
        .what = "%1",
        .action = QT_TRANSLATE_NOOP("Text", "Boresight looks for the board every 2 s"),
        .remedy = "%2",
        .help = AlarmHelp::OpenProfile,
        .kin = AlarmKin::Silence,
        .examples = {"the board of azimuth (id 1) does not answer",
                     "Check its power, its plugs and the bus cable. If it has another id, enter that in the profile."}},
    AlarmEntry{.id = "drives.shared-id",
               .source = "drives",
               .severity = Severity::Warning,
               .worst = Severity::Alarm,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "Boresight moves nothing"),
               .remedy = "%2",
               .help = AlarmHelp::OpenDrives,
               .kin = AlarmKin::BusDisturbed,
               .examples = {"two boards have the id 1, so their answers collide",
                            "Open the guide (F3), step Connect. It sets the ids of the boards one after the other."}},
    AlarmEntry{.id = "drives.foreign-board",
               .source = "drives",
               .severity = Severity::Warning,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "Boresight does not use this board"),
               .remedy = "%2",
               .help = AlarmHelp::OpenProfile,
               .examples = {"a board with the id 5 is not in the profile",
                            "Take it off the bus, or enter its id in the profile if it drives an axis."}},
    AlarmEntry{
        .id = "drives.swapped",
        .source = "drives",
        .severity = Severity::Alarm,
        .what = "%1",
        .action = QT_TRANSLATE_NOOP("Text", "Boresight moves nothing, because commands would reach the wrong axis"),
        .remedy = "%2",
        .help = AlarmHelp::OpenProfile,
        .examples = {"the ids are swapped, and the board with the id 1 (azimuth) was the board of elevation",
                     "Exchange the ids in the profile."}},
    AlarmEntry{
        .id = "drives.other-board",
        .source = "drives",
        .severity = Severity::Warning,
        .what = "%1",
        .action = QT_TRANSLATE_NOOP("Text", "Boresight treats the cable wrap of this axis as unknown"),
        .remedy = "%2",
        .examples =
            {"azimuth has another board than before",
             "If you exchanged it, check calibration and gains. If not, check whether another mount is connected."}},
    AlarmEntry{
        .id = "drives.register-map",
        .source = "drives",
        .severity = Severity::Alarm,
        .what = "%1",
        .action = QT_TRANSLATE_NOOP(
            "Text", "Boresight moves nothing, because the reports of the board may mean something else"),
        .remedy = "%2",
        .examples =
            {"the board of azimuth has the register map 4, but Boresight knows only version 5",
             "Install firmware with the register map 5 in the board (moteus_tool --flash), or a newer Boresight."}},
    AlarmEntry{.id = "drives.unread",
               .source = "drives",
               .severity = Severity::Alarm,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "Boresight reads the settings again every 2 s"),
               .remedy = "%2",
               .kin = AlarmKin::Silence,
               .examples = {"the check of azimuth ended early: it does not answer",
                            "Check its power, its plugs and the bus cable."}},
    AlarmEntry{.id = "drives.not-stored",
               .source = "drives",
               .severity = Severity::Warning,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "Boresight read the settings again"),
               .remedy = "%2",
               .help = AlarmHelp::OpenProtection,
               .examples = {"azimuth did not store its settings: it does not answer", "Press Fix again."}},
    AlarmEntry{.id = "drives.dangerous",
               .source = "drives",
               .severity = Severity::Alarm,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "Boresight moves nothing"),
               .remedy = "%2",
               .help = AlarmHelp::OpenProtection,
               .examples = {"a setting of the azimuth drive is unsafe: servo.default_timeout_s is nan, needed 0.1",
                            "Open the page Protection and press Fix. For a wrong gear ratio press Set gear."}},
    AlarmEntry{
        .id = "drives.advised",
        .source = "drives",
        .severity = Severity::Advisory,
        .what = "%1",
        .action = QT_TRANSLATE_NOOP("Text", "The mount may still move"),
        .remedy = "%2",
        .help = AlarmHelp::OpenProtection,
        .examples = {"a setting of the azimuth drive is worth fixing: servopos.position_max is 460.0°, needed 453.0°",
                     "Open the page Protection and press Fix. For a wrong gear ratio press Set gear."}},
};

}  // namespace boresight
