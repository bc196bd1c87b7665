// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/journal/mount_journal.h"

// A realistic stored memory of a mount, for the tests of text and file.
namespace boresight::journal {

inline const QString kAzimuthDrive = QStringLiteral("6f1c2a90-0b7d-4e11-8c55-0123456789ab");
inline const QString kElevationDrive = QStringLiteral("d2b4a7e1-55aa-4c3c-9f00-fedcba987654");
inline const QString kBoot = QStringLiteral("0d5c1b1e-7a52-4b7c-a1ea-3f1f6d1f7f10");

inline const UtcTime kWhen =
    std::chrono::sys_days{std::chrono::year{2026} / 11 / 21} + std::chrono::hours(12) + std::chrono::milliseconds(345);

inline MountJournal exampleJournal()
{
    MountJournal journal;
    journal.turns[0] =
        TurnRecord{.drive = kAzimuthDrive,
                   .angle = Angle::fromDegrees(405.1),
                   .reported = MotorTurns::fromTurns(0.1 + 0.2),
                   .counted = Angle::fromDegrees(45.1),
                   .uptime = Seconds(1234.567),
                   .homeState = moteus::HomeState::Output,
                   .origin = moteus::CountOrigin{.beginning = 65793, .offset = MotorTurns::fromTurns(-1.0 / 3.0)},
                   .when = kWhen,
                   .host = {.boot = kBoot, .sinceBoot = Seconds(98765.4321), .utcIsExact = true},
                   .moving = true};
    journal.turns[1] = TurnRecord{.drive = kElevationDrive, .angle = Angle::fromDegrees(-0.3), .when = kWhen};
    journal.crashStops[1] = CrashStop{.drive = kElevationDrive,
                                      .rate = AngularRate::fromDegrees(-2.0),
                                      .angle = Angle::fromDegrees(0.137),
                                      .time = std::chrono::milliseconds(183),
                                      .when = kWhen};
    journal.placeUsed = kWhen;
    return journal;
}

}  // namespace boresight::journal
