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
        .action = QT_TRANSLATE_NOOP("Text", "it is looked for every 2 seconds"),
        .remedy = "%2",
        .examples =
            {"the board of azimuth is missing: nobody answers under id 1",
             "Look at its power, its plugs and the bus cable. If it has another id, enter that in the profile."}},
    AlarmEntry{.id = "drives.shared-id",
               .source = "drives",
               .severity = Severity::Warning,
               .worst = Severity::Alarm,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "nothing is moved"),
               .remedy = "%2",
               .examples = {"two boards have the id 1: their answers destroy each other",
                            "Leave only one of them connected and give it another id, then connect the other again."}},
    AlarmEntry{.id = "drives.foreign-board",
               .source = "drives",
               .severity = Severity::Warning,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "it is left alone"),
               .remedy = "%2",
               .examples = {"a board that the profile does not know answers under id 5",
                            "Take it off the bus, or enter its id in the profile if it drives an axis."}},
    AlarmEntry{.id = "drives.swapped",
               .source = "drives",
               .severity = Severity::Alarm,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "nothing is moved: the orders of one axis would reach the other"),
               .remedy = "%2",
               .examples = {"the ids are swapped: the board under id 1 (azimuth) was the one of elevation",
                            "Exchange the ids in the profile, or those of the boards."}},
    AlarmEntry{
        .id = "drives.other-board",
        .source = "drives",
        .severity = Severity::Warning,
        .what = "%1",
        .action = QT_TRANSLATE_NOOP("Text", "its turn is taken as unknown"),
        .remedy = "%2",
        .examples =
            {"azimuth has another board than before",
             "If it was exchanged, check calibration and gains. If not, look whether another mount is connected."}},
    AlarmEntry{
        .id = "drives.register-map",
        .source = "drives",
        .severity = Severity::Alarm,
        .what = "%1",
        .action = QT_TRANSLATE_NOOP("Text", "nothing is moved: what it reports may mean something else"),
        .remedy = "%2",
        .examples =
            {"the board of azimuth has the register map 4; only version 5 is known here",
             "Install firmware with the register map 5 in the board (moteus_tool --flash), or a newer Boresight."}},
    AlarmEntry{.id = "drives.unread",
               .source = "drives",
               .severity = Severity::Alarm,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "it is tried again every 2 seconds"),
               .remedy = "%2",
               .examples = {"the settings of the azimuth drive could not be read",
                            "Look at its power, its plugs and the bus cable."}},
    AlarmEntry{.id = "drives.not-stored",
               .source = "drives",
               .severity = Severity::Warning,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "the settings were read again"),
               .remedy = "%2",
               .examples = {"a setting of the azimuth drive was not stored", "Press Fix again."}},
    AlarmEntry{.id = "drives.dangerous",
               .source = "drives",
               .severity = Severity::Alarm,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "nothing is moved"),
               .remedy = "%2",
               .examples = {"a setting of the azimuth drive is dangerous: servo.default_timeout_s",
                            "See the Protection page; Fix writes what can be written."}},
    AlarmEntry{.id = "drives.advised",
               .source = "drives",
               .severity = Severity::Advisory,
               .what = "%1",
               .action = QT_TRANSLATE_NOOP("Text", "the mount may move all the same"),
               .remedy = "%2",
               .examples = {"a setting of the azimuth drive is worth fixing: servopos.position_max",
                            "See the Protection page; Fix writes what can be written."}},
};

}  // namespace boresight
