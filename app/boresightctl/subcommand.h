// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <span>
#include <string>
#include <string_view>

// The subcommands of boresightctl. Each subcommand is one file that offers one entry of the table in main.cpp.
namespace boresight::ctl {

enum ExitStatus : int
{
    kDone = 0,
    kFoundWrong = 1,    // the work was done or tried, and something is wrong
    kUsage = 2,         // the command line is invalid
    kNoConnection = 3,  // no station answers
};

using Arguments = std::span<const std::string>;  // the arguments after the name of the subcommand

struct Subcommand
{
    std::string_view name;
    std::string_view arguments;  // "BUS"
    std::string_view summary;    // one line without a full stop
    std::string details;         // options, exit status, an example; ends with LF
    ExitStatus (*run)(Arguments arguments);
};

extern const Subcommand kSimulateCommand;
extern const Subcommand kScanCommand;
extern const Subcommand kDecodeCommand;
extern const Subcommand kCheckCommand;
extern const Subcommand kProfileCommand;
extern const Subcommand kConfirmDirectionsCommand;
extern const Subcommand kEphemerisCommand;
extern const Subcommand kPassesCommand;
extern const Subcommand kPlanCommand;
extern const Subcommand kExportCommand;
extern const Subcommand kReplayCommand;
extern const Subcommand kReportCommand;
extern const Subcommand kGotoCommand;
extern const Subcommand kStopCommand;
extern const Subcommand kResetStopCommand;
extern const Subcommand kOverrideWindCommand;
extern const Subcommand kUseNewTimeCommand;
extern const Subcommand kTakeCommand;
extern const Subcommand kReleaseCommand;
extern const Subcommand kScheduleCommand;
extern const Subcommand kParkCommand;
extern const Subcommand kStatusCommand;
extern const Subcommand kTrackCommand;
extern const Subcommand kAntennaCommand;
extern const Subcommand kSatellitesCommand;
extern const Subcommand kConsoleCommand;
extern const Subcommand kProtocolLogCommand;

// Prints to standard output without delay, also into a pipe: text for programs, and tables and help of fixed width.
void print(const std::string& text);
// The same for one line that a person reads.
void printLine(const QString& line);
// Prints "boresightctl scan: TEXT" to standard error.
void complain(const Subcommand& subcommand, const QString& text);
// The same, followed by how to get the usage.
ExitStatus usageError(const Subcommand& subcommand, const QString& text);

}  // namespace boresight::ctl
