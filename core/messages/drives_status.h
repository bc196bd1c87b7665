// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/crash_stop.h"
#include "core/messages/drive_gains.h"
#include "core/messages/drive_identity.h"
#include "core/messages/protection_line.h"
#include "core/messages/turn_question.h"

#include <QList>
#include <QString>

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

// What the station reports about drives that can be read and set: their identity, their safety settings, the question
// to the operator about the wrap of each axis, and how they stop without commands. Plain values. Part of a
// StationStatus if the mount has such drives.
namespace boresight {

enum class DriveCheckState
{
    NotDone,  // no drive answers, or the bus was lost after the last check
    Running,  // scan, identification or reading
    Fixing,   // settings are being written
    Done,
};

// The values that a drive reports, unchanged. Empty: the drive did not report this value.
struct DriveReadings
{
    std::optional<double> motorTurns;
    std::optional<double> motorTurnsPerSecond;
    std::optional<double> torque;            // Nm
    std::optional<double> qCurrent;          // A
    std::optional<double> dCurrent;          // A
    std::optional<double> busVoltage;        // V
    std::optional<double> boardTemperature;  // °C
    std::optional<double> motorTemperature;  // °C
    std::optional<double> power;             // W
    QString mode;                            // in the words of the drive, with its number
    QString fault;                           // in the words of the drive, with its number, or "none"
    std::optional<std::chrono::milliseconds> age;
    std::uint64_t sent = 0;      // since the line was opened
    std::uint64_t answered = 0;  // how many of them were answered
};

// The gear in the drive differs from the profile, and can be set.
struct GearCorrection
{
    QString found;   // "1"
    QString wanted;  // "0.01"
    QString effect;  // what else depends on the gear, in sentences
};

struct DriveStatus
{
    bool present = true;  // this axis has such a drive; false: the other members mean nothing
    int id = 0;           // on the bus; 0 until the drive has answered
    DriveIdentity identity;
    DriveReadings readings;
    QString registers;                         // mode and fault in the words of the drive; may be empty
    QList<ProtectionLine> protections;         // a list that copies share: a status is copied many times a second
    std::optional<TurnQuestion> turnQuestion;  // waits for the operator
    std::optional<CrashStop> crashStop;        // of the last crash-stop test
    DriveGains gains;
    std::optional<GearCorrection> gear;  // empty: the gear is right or was not read
};

// An id or a gear that is written into one board.
struct BoardWork
{
    bool running = false;
    bool failed = false;
    QString text;  // the running action, or the result of the last one; empty: nothing was requested
};

// A board on the bus that turns no axis.
struct WatchedDrive
{
    int id = 0;
    QString name;
    DriveReadings readings;
};

struct DrivesStatus
{
    DriveCheckState driveCheck = DriveCheckState::NotDone;
    QString driveCheckText;                   // while running: "reading servo.timeout_mode of azimuth"
    QString armingObstacle;                   // the interlock: why nothing may move yet; empty: the drives are ready
    bool released = false;                    // the bus is left to other tools
    bool switchedOn = false;                  // a drive obeys Boresight, so its settings cannot be written
    bool fixable = false;                     // Fix has a setting to write or to store
    bool proofRunning = false;                // the crash-stop test moves the mount
    QString proofText;                        // the present step of the crash-stop test, or its result
    std::vector<UnknownBoard> unknownBoards;  // boards that the profile does not name
    std::vector<BoardOnBus> boards;           // all boards, ordered by id
    BoardWork boardWork;                      // writing an id into a board; kept until the boards change
    BoardWork gearWork;                       // writing a gear into a drive
    DriveStatus azimuth;
    DriveStatus elevation;
    std::vector<WatchedDrive> watched;
};

}  // namespace boresight
