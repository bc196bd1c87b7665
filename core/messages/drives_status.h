// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/crash_stop.h"
#include "core/messages/drive_gains.h"
#include "core/messages/drive_identity.h"
#include "core/messages/protection_line.h"
#include "core/messages/turn_question.h"

#include <QString>

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

// What the station tells about drives that can be read and set: who they are, whether their own protections are right,
// what the operator is asked about the turn of each axis, and how they stop when nobody feeds them. Plain values, part
// of a StationStatus where the mount has such drives.
namespace boresight {

enum class DriveCheckState
{
    NotDone,  // nobody answers, or the bus was lost since
    Running,  // scan, identification or reading
    Fixing,   // settings are being written
    Done,
};

// What a drive reports itself, as it says it. Empty: it did not report this.
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
    QString mode;                            // in the drive's own words, with its number
    QString fault;                           // the same; "none"
    std::optional<std::chrono::milliseconds> age;
    std::uint64_t sent = 0;      // since the line was opened
    std::uint64_t answered = 0;  // of those
};

// The gear in the drive differs from the profile, and can be set.
struct GearCorrection
{
    QString found;   // "1"
    QString wanted;  // "0.01"
    QString effect;  // what else depends on it, in sentences
};

struct DriveStatus
{
    bool present = true;  // this axis has such a drive; else nothing more is told
    int id = 0;           // on the bus; 0 until somebody answered
    DriveIdentity identity;
    DriveReadings readings;
    QString registers;  // what it says of itself, in its own words: mode and fault; may be empty
    std::vector<ProtectionLine> protections;
    std::optional<TurnQuestion> turnQuestion;  // waits for the operator
    std::optional<CrashStop> crashStop;        // of the last proof
    DriveGains gains;
    std::optional<GearCorrection> gear;  // empty: it is right, or unread
};

// An id or a gear that is written into one board.
struct BoardWork
{
    bool running = false;
    bool failed = false;
    QString text;  // what it does, or how it ended; empty: nothing was asked for
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
    QString armingObstacle;                   // why nothing may move yet; empty when the drives are fit
    bool released = false;                    // the bus is left to other tools
    bool switchedOn = false;                  // a drive is under our orders: settings can not be written
    bool fixable = false;                     // Fix has something to write or to store
    bool proofRunning = false;                // the crash-stop proof moves the mount
    QString proofText;                        // what it does now, or how it ended
    std::vector<UnknownBoard> unknownBoards;  // boards that the profile does not know
    std::vector<BoardOnBus> boards;           // all of them, by their ids
    BoardWork boardWork;                      // an id that is given to a board, until the boards change
    BoardWork gearWork;
    DriveStatus azimuth;
    DriveStatus elevation;
    std::vector<WatchedDrive> watched;
};

}  // namespace boresight
