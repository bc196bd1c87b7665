// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/goto_answer.h"
#include "app/boresightctl/local_client.h"
#include "app/boresightctl/rotctld_client.h"
#include "app/boresightctl/station_help.h"
#include "app/boresightctl/station_options.h"
#include "app/boresightctl/station_report.h"
#include "app/boresightctl/subcommand.h"

#include <QJsonDocument>

#include <vector>

namespace boresight::ctl {
namespace {

// Asks `station` for one thing, and prints `done` when the station agrees.
template <class Ask>
ExitStatus orderOf(const Subcommand& subcommand, const StationOptions& options, const Ask& ask, const QString& done)
{
    RotctldClient station;
    const Result<> answer =
        station.connect(options.station.value_or(profile::ListenAddress{})).and_then([&] { return ask(station); });
    if (!answer) {
        return failedBy(subcommand, answer.error());
    }
    printLine(done);
    return kDone;
}

QString doneText(local::LocalCommand command)
{
    switch (command) {
        case local::LocalCommand::Take:
            return QStringLiteral(
                "The operator has control. The station refuses motion commands of clients until release.");
        case local::LocalCommand::Release:
            return QStringLiteral("The clients have control. A client may move the mount at once.");
        case local::LocalCommand::ResetStop:
            return QStringLiteral("STOP is reset. Clients are refused until release.");
        case local::LocalCommand::OverrideWind:
            return QStringLiteral(
                "The mount may move in the wind for the time of the profile. Then the mount parks again.");
        case local::LocalCommand::UseNewTime:
            return QStringLiteral("The station uses the time of this computer. A tracked target may be elsewhere now.");
        case local::LocalCommand::Stop:
        case local::LocalCommand::Track:
        case local::LocalCommand::Satellites:
        case local::LocalCommand::Antennas:
        case local::LocalCommand::UseAntenna:
        case local::LocalCommand::ScheduleList:
        case local::LocalCommand::ScheduleArm:
        case local::LocalCommand::ScheduleDisarm:
        case local::LocalCommand::ScheduleReport:
        case local::LocalCommand::ScheduleRehearse:
        case local::LocalCommand::ScheduleRehearsal:
        case local::LocalCommand::Status:
        case local::LocalCommand::Transmit:
        case local::LocalCommand::Simulate:
        case local::LocalCommand::TypeLine:
        case local::LocalCommand::ConsoleLines:
        case local::LocalCommand::ProtocolLogOn:
        case local::LocalCommand::ProtocolLogOff:
        case local::LocalCommand::ProtocolLines:
            break;
    }
    return QStringLiteral("STOP is latched. The mount slows down and holds. Nothing moves it until reset-stop.");
}

// The same through the local socket, for commands that rotctld lacks.
template <const Subcommand& subcommand, local::LocalCommand command>
ExitStatus runLocally(Arguments arguments)
{
    const auto options = parseStationOptions(arguments, 0);
    if (!options) {
        return usageError(subcommand, options.error().text);
    }
    const auto answer = askLocally(options->station.value_or(profile::ListenAddress{}), {.command = command});
    if (!answer) {
        return failedBy(subcommand, answer.error());
    }
    printLine(doneText(command));
    return kDone;
}

ExitStatus runGoto(Arguments arguments)
{
    const auto options = parseStationOptions(arguments, 2);
    if (!options) {
        return usageError(kGotoCommand, options.error().text);
    }
    const auto direction = parseDirection(options->places[0], options->places[1]);
    if (!direction) {
        return usageError(kGotoCommand, direction.error().text);
    }
    RotctldClient station;
    const auto outcome = station.connect(options->station.value_or(profile::ListenAddress{})).and_then([&] {
        return station.pointTo(*direction);
    });
    if (!outcome) {
        return failedBy(kGotoCommand, outcome.error());
    }
    const GotoAnswer answer = gotoAnswer(*direction, *outcome);
    if (!answer.goesThere) {
        complain(kGotoCommand, answer.text);
        return kFoundWrong;
    }
    printLine(answer.text);
    return kDone;
}

ExitStatus runStop(Arguments arguments)
{
    std::vector<std::string> rest(arguments.begin(), arguments.end());
    if (std::erase(rest, "--latched") > 0) {
        return runLocally<kStopCommand, local::LocalCommand::Stop>(rest);
    }
    const auto options = parseStationOptions(arguments, 0);
    return options
               ? orderOf(
                     kStopCommand, *options, [](RotctldClient& station) { return station.hold(); },
                     QStringLiteral("The motion has ended. STOP is not latched: a client can move the mount again."))
               : usageError(kStopCommand, options.error().text);
}

ExitStatus runPark(Arguments arguments)
{
    const auto options = parseStationOptions(arguments, 0);
    return options ? orderOf(
                         kParkCommand, *options, [](RotctldClient& station) { return station.park(); },
                         QStringLiteral("The station accepted the park position as the target."))
                   : usageError(kParkCommand, options.error().text);
}

// The answer of a station on this computer. Empty: it does not answer.
QJsonObject toldLocally(const profile::ListenAddress& station, local::LocalCommand question)
{
    const auto answer = askLocally(station, {.command = question});
    return QJsonDocument::fromJson(answer.value_or(QByteArray())).object();
}

// rotctld only reports whether an axis moves, so it does not show that a slow mount is tracking. The station of this
// computer reports what its window shows, and its transmit output if it has one.
void addLocal(QJsonObject& report, const profile::ListenAddress& station)
{
    if (!hasLocalSocket(station)) {
        return;
    }
    const QJsonObject status = toldLocally(station, local::LocalCommand::Status);
    for (auto field = status.begin(); field != status.end(); ++field) {
        report[field.key()] = field.value();
    }
    const QJsonObject transmit = toldLocally(station, local::LocalCommand::Transmit);
    if (!transmit.isEmpty()) {
        report[QStringLiteral("transmit")] = transmit;
    }
}

ExitStatus runStatus(Arguments arguments)
{
    const auto options = parseStationOptions(arguments, 0);
    if (!options) {
        return usageError(kStatusCommand, options.error().text);
    }
    RotctldClient station;
    const profile::ListenAddress address = options->station.value_or(profile::ListenAddress{});
    auto report = station.connect(address).and_then([&] { return station.status(); });
    if (!report) {
        return failedBy(kStatusCommand, report.error());
    }
    addLocal(*report, address);
    print(options->json ? QJsonDocument(*report).toJson().toStdString() : reportText(*report).toStdString());
    return kDone;
}

}  // namespace

const Subcommand kGotoCommand{.name = "goto",
                              .arguments = "AZ EL [--station HOST:PORT]",
                              .summary = "Send the mount of a running station to a direction",
                              .details = kWhichStation +
                                         R"(
AZ and EL are true directions in degrees. The command ends when the station has accepted the target. The motion continues.
The station treats the command like that of any client. It refuses the command while STOP is latched, and while the
operator or another client has control. The profile sets what happens with a direction outside the limits: the station
refuses it, or moves to the nearest permitted direction. The command prints the reason, and where the mount goes. A
rotctld of Hamlib reports neither.
Exit status: 0 the mount goes there, 1 the station refused it or the mount goes to the nearest permitted direction, 2 the
command line is wrong, 3 no station answered in 2 s.

Example:
  boresightctl goto 113 10
)",
                              .run = runGoto};

const Subcommand kStopCommand{
    .name = "stop",
    .arguments = "[--latched] [--station HOST:PORT]",
    .summary = "End the motion of the mount of a running station",
    .details = kWhichStation +
               R"(  --latched            STOP like the button of the window: nothing moves the mount until reset-stop

The mount slows down and holds. Without --latched the next target of a client moves the mount again. With --latched the
operator has control afterwards. Switch off the power of the drives before you go to the mount.

rotctld has no STOP that latches. So --latched uses the local socket of the station,
$XDG_RUNTIME_DIR/boresight/PORT.sock. It works on the computer of the station, for the user who started the station. The
service has the socket /run/boresight/PORT.sock, for root: use sudo.
)" + kExitStatus +
               R"(
Example:
  boresightctl stop --latched
)",
    .run = runStop};

const Subcommand kResetStopCommand{.name = "reset-stop",
                                   .arguments = "[--station HOST:PORT]",
                                   .summary = "Reset a latched STOP of a running station",
                                   .details = kWhichLocalStation + kLocalSocket +
                                              R"(
This command moves nothing. The operator keeps control. The station refuses the command while the mount still slows down.
)" + kExitStatus + R"(
Example:
  boresightctl reset-stop && boresightctl release
)",
                                   .run = runLocally<kResetStopCommand, local::LocalCommand::ResetStop>};

const Subcommand kOverrideWindCommand{.name = "override-wind",
                                      .arguments = "[--station HOST:PORT]",
                                      .summary =
                                          "Let the operator move the mount of a running station in a strong wind",
                                      .details = kWhichLocalStation + kLocalSocket +
                                                 R"(
The permission lasts for wind.override_min of the profile. This command moves nothing. The station refuses the command
while the wind forbids nothing.
)" + kExitStatus + R"(
Example:
  boresightctl override-wind
)",
                                      .run = runLocally<kOverrideWindCommand, local::LocalCommand::OverrideWind>};

const Subcommand kUseNewTimeCommand{.name = "use-new-time",
                                    .arguments = "[--station HOST:PORT]",
                                    .summary = "Let a running station use the clock of its computer after it was set",
                                    .details = kWhichLocalStation + kLocalSocket +
                                               R"(
When the clock of the computer is set while the station tracks a target or its schedule is armed, the station continues
with the old time. This command confirms the new time, like the button of the window. A mount that tracks a target moves to
where the target is at the new time. The station refuses the command while it uses the time of the computer.
)" + kExitStatus + R"(
Example:
  boresightctl use-new-time
)",
                                    .run = runLocally<kUseNewTimeCommand, local::LocalCommand::UseNewTime>};

const Subcommand kTakeCommand{.name = "take",
                              .arguments = "[--station HOST:PORT]",
                              .summary = "Take control of a running station from its clients",
                              .details = kWhichLocalStation + kLocalSocket +
                                         R"(
The motion of a client ends, and the mount holds. The station refuses motion commands of clients until release. This
includes goto and park of boresightctl.
)" + kExitStatus + R"(
Example:
  boresightctl take
)",
                              .run = runLocally<kTakeCommand, local::LocalCommand::Take>};

const Subcommand kReleaseCommand{.name = "release",
                                 .arguments = "[--station HOST:PORT]",
                                 .summary = "Give control of a running station back to its clients",
                                 .details = kWhichLocalStation + kLocalSocket +
                                            R"(
This command moves nothing. A client that still sends its target moves the mount at once. The station refuses the command
while STOP is latched.
)" + kExitStatus + R"(
Example:
  boresightctl release
)",
                                 .run = runLocally<kReleaseCommand, local::LocalCommand::Release>};

const Subcommand kParkCommand{.name = "park",
                              .arguments = "[--station HOST:PORT]",
                              .summary = "Send the mount of a running station to its park position",
                              .details = kWhichStation +
                                         R"(
The command ends when the station has accepted the park position as its target. The motion continues.
)" + kExitStatus + R"(
Example:
  boresightctl park --station mast.example:4533
)",
                              .run = runPark};

const Subcommand kStatusCommand{.name = "status",
                                .arguments = "[--station HOST:PORT] [--format text|json]",
                                .summary = "Show what the mount of a running station does",
                                .details = kWhichStation +
                                           R"(  --format text|json   default: text

Prints the station, its state, and where the mount points. A station of this user on this computer also reports by its
local socket: the state that its window shows (TRACK, HOLD, …), the motion, the next rise or set of the tracked target,
the error budget with its parts, whether the schedule is armed, the wind, the brake, the end switches, the third axis,
whether the transmit output is on, whether the station still uses the old time after its clock was set, and the alarms. A station on another computer reports only by rotctld.
Its state is MOVING, or SLOW OR NOT MOVING: rotctld reports no motion below 0.02°/s, for example while the mount tracks the
Moon.
)" + kExitStatus + R"(
Example:
  boresightctl status --format json
)",
                                .run = runStatus};

}  // namespace boresight::ctl
