// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/local_client.h"
#include "app/boresightctl/record_table.h"
#include "app/boresightctl/station_options.h"
#include "app/boresightctl/subcommand.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>
#include <string>

namespace boresight::ctl {
namespace {

struct ScheduleAction
{
    const char* word;
    local::LocalCommand command;
};
constexpr std::array kActions{ScheduleAction{"list", local::LocalCommand::ScheduleList},
                              ScheduleAction{"arm", local::LocalCommand::ScheduleArm},
                              ScheduleAction{"disarm", local::LocalCommand::ScheduleDisarm},
                              ScheduleAction{"report", local::LocalCommand::ScheduleReport}};

std::string cell(const QJsonObject& row, const char* key)
{
    const QJsonValue value = row[QLatin1String(key)];
    return value.isDouble() ? QString::number(value.toDouble(), 'g', 12).toStdString() : value.toString().toStdString();
}

// The columns are the names of what the station says.
std::string tableOfRows(const std::vector<TableColumn>& columns, const QJsonArray& rows)
{
    RecordTable table{.columns = columns, .rows = {}};
    for (const QJsonValue& row : rows) {
        std::vector<std::string>& cells = table.rows.emplace_back();
        for (const TableColumn& column : columns) {
            cells.push_back(cell(row.toObject(), std::string(column.name).c_str()));
        }
    }
    return table.text(TableFormat::Table);
}

std::string conflictLine(const QJsonObject& conflict)
{
    const QJsonObject leftOut = conflict[QStringLiteral("left_out")].toObject();
    const QJsonObject chosen = conflict[QStringLiteral("chosen")].toObject();
    return cell(leftOut, "aos_utc") + "  " + cell(leftOut, "name") + " is left out for " + cell(chosen, "name") +
           " at " + cell(chosen, "aos_utc") + " (" + cell(conflict, "by") +
           (conflict[QStringLiteral("overlap")].toBool() ? ", they overlap)\n" : ", too short a time between them)\n");
}

std::string listText(const QJsonObject& plan)
{
    std::string text = plan[QStringLiteral("armed")].toBool() ? "The schedule is armed.\n" : "The schedule is off.\n";
    if (const std::string why = cell(plan, "why"); !why.empty()) {
        text += why + "\n";
    }
    text += tableOfRows({{"aos_utc"}, {"los_utc"}, {"norad", true}, {"name"}, {"priority", true}, {"max_el", true}},
                        plan[QStringLiteral("passes")].toArray());
    for (const QJsonValue& conflict : plan[QStringLiteral("conflicts")].toArray()) {
        text += conflictLine(conflict.toObject());
    }
    for (const QJsonValue& pass : plan[QStringLiteral("hidden")].toArray()) {
        text += cell(pass.toObject(), "aos_utc") + "  " + cell(pass.toObject(), "name") +
                " is left out (hidden by the horizon, a keep-out or a limit of the mount)\n";
    }
    return text;
}

std::string nightText(const QJsonObject& report)
{
    return "passes done: " + cell(report, "done") + ", interventions: " + cell(report, "interventions") +
           ", faults: " + cell(report, "faults") + "\n" +
           tableOfRows({{"aos_utc"},
                        {"norad", true},
                        {"name"},
                        {"tracked_s", true},
                        {"within_1db_s", true},
                        {"within_3db_s", true},
                        {"rms_deg", true},
                        {"peak_deg", true},
                        {"end"},
                        {"why"}},
                       report[QStringLiteral("passes")].toArray());
}

void printAnswer(local::LocalCommand command, const QByteArray& answer, bool json)
{
    const QJsonDocument document = QJsonDocument::fromJson(answer);
    switch (command) {
        case local::LocalCommand::ScheduleList:
            print(json ? document.toJson().toStdString() : listText(document.object()));
            break;
        case local::LocalCommand::ScheduleReport:
            print(json ? document.toJson().toStdString() : nightText(document.object()));
            break;
        case local::LocalCommand::ScheduleArm:
            printLine(QStringLiteral("The schedule is armed. The mount moves by itself for each pass."));
            break;
        default:
            printLine(QStringLiteral("The schedule is off. The mount holds."));
            break;
    }
}

ExitStatus runSchedule(Arguments arguments)
{
    const auto* const action = std::ranges::find_if(
        kActions, [&](const ScheduleAction& one) { return !arguments.empty() && arguments.front() == one.word; });
    if (action == kActions.end()) {
        return usageError(kScheduleCommand, QStringLiteral("give list, arm, disarm or report"));
    }
    const auto options = parseStationOptions(arguments.subspan(1), 0);
    if (!options) {
        return usageError(kScheduleCommand, options.error().text);
    }
    const local::LocalAnswer answer =
        askLocally(options->station.value_or(profile::ListenAddress{}), {.command = action->command});
    if (answer) {
        printAnswer(action->command, *answer, options->json);
        return kDone;
    }
    if (answer.error().code == ErrorCode::InvalidInput) {
        return usageError(kScheduleCommand, answer.error().text);
    }
    const bool isRefused = answer.error().code == ErrorCode::Refused;
    complain(kScheduleCommand, (isRefused ? QStringLiteral("refused: ") : QString()) + answer.error().text);
    return isRefused ? kFoundWrong : kNoConnection;
}

}  // namespace

const Subcommand kScheduleCommand{
    .name = "schedule",
    .arguments = "list|arm|disarm|report [--station HOST:PORT] [--format text|json]",
    .summary = "List, arm or disarm the schedule of passes of a running station, or show its report",
    .details =
        R"(  list                 the passes that are chosen in the next 24 h, and those left out, with the reason
  arm                  the station tracks each of these passes by itself. It takes the control from the clients
  disarm               the pass that is tracked ends, and the mount holds
  report               the passes so far: seconds tracked, within 1 and 3 dB of the beam, rms and peak error, how it ended
  --station HOST:PORT  the rotctld port of the station; 127.0.0.1:4533 without it
                       HOST is localhost, 127.0.0.1 or ::1: the station runs on this computer
  --format text|json   text without it

The satellites, their priorities and lowest elevations are the list "watch" of the profile. After each start of the
station the schedule is off until somebody arms it, unless schedule.unattended is "on" in the profile. Any other command
to the mount, STOP and a fault disarm it.

The command goes through the local socket of the station, $XDG_RUNTIME_DIR/boresight/PORT.sock. It works on the computer
of the station, for the user who started the station. The socket of the service is /run/boresight/PORT.sock, for root: use
sudo.
Exit status: 0 done, 1 the station refused it, 2 the command line makes no sense, 3 no station answered in 2 s.

Example:
  boresightctl schedule arm && boresightctl schedule list
)",
    .run = runSchedule};

}  // namespace boresight::ctl
