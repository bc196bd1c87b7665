// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/local_client.h"
#include "app/boresightctl/record_table.h"
#include "app/boresightctl/station_options.h"
#include "app/boresightctl/subcommand.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QThread>

#include <algorithm>
#include <array>
#include <chrono>
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
                              ScheduleAction{"report", local::LocalCommand::ScheduleReport},
                              ScheduleAction{"rehearse", local::LocalCommand::ScheduleRehearse}};
constexpr std::chrono::milliseconds kBetweenLooks{200};

std::string cell(const QJsonObject& row, const char* key)
{
    const QJsonValue value = row[QLatin1String(key)];
    return value.isDouble() ? QString::number(value.toDouble(), 'g', 12).toStdString() : value.toString().toStdString();
}

// The columns are named like the keys in the answer of the station.
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
    std::string line =
        cell(leftOut, "aos_utc") + "  " + cell(leftOut, "name") + " is left out for " + cell(chosen, "name") + " at " +
        cell(chosen, "aos_utc") + " (" + cell(conflict, "by") +
        (conflict[QStringLiteral("overlap")].toBool() ? ", they overlap)" : ", too short a time between them)");
    for (const QJsonValue& part : conflict[QStringLiteral("tracked")].toArray()) {
        line += ", but tracked from " + cell(part.toObject(), "from_utc") + " to " + cell(part.toObject(), "to_utc");
    }
    return line + "\n";
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

std::string rehearsalText(const QJsonObject& night)
{
    std::string text = "rehearsed from " + cell(night, "from_utc") + " to " + cell(night, "to_utc") +
                       ", passes planned: " + cell(night, "planned") +
                       ", left out for another: " + cell(night, "conflicts") + ", hidden: " + cell(night, "hidden") +
                       "\nazimuth axis from " + cell(night, "axis_from_deg") + " to " + cell(night, "axis_to_deg") +
                       " deg\n" + nightText(night[QStringLiteral("report")].toObject());
    for (const QJsonValue& remark : night[QStringLiteral("remarks")].toArray()) {
        text += cell(remark.toObject(), "utc") + "  " + cell(remark.toObject(), "text") + "\n";
    }
    if (const std::string why = cell(night, "disarmed"); !why.empty()) {
        text += "the schedule would end here: " + why + "\n";
    }
    return text;
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
        case local::LocalCommand::ScheduleRehearsal:
            print(json ? document.toJson().toStdString() : rehearsalText(document[QStringLiteral("night")].toObject()));
            break;
        case local::LocalCommand::ScheduleArm:
            printLine(QStringLiteral("The schedule is armed. The mount moves by itself for each pass."));
            break;
        default:
            printLine(QStringLiteral("The schedule is off. The mount holds."));
            break;
    }
}

// Waits for the end of the rehearsal and returns its result.
local::LocalAnswer awaitRehearsal(const profile::ListenAddress& station)
{
    while (true) {
        const local::LocalAnswer answer = askLocally(station, {.command = local::LocalCommand::ScheduleRehearsal});
        const QJsonDocument document = QJsonDocument::fromJson(answer.value_or(QByteArray()));
        if (!answer || document[QStringLiteral("progress")].isNull()) {
            const QString problem = document[QStringLiteral("problem")].toString();
            return problem.isEmpty() ? answer : failure(ErrorCode::Refused, problem);
        }
        QThread::msleep(kBetweenLooks.count());
    }
}

ExitStatus runSchedule(Arguments arguments)
{
    const auto* const action = std::ranges::find_if(
        kActions, [&](const ScheduleAction& one) { return !arguments.empty() && arguments.front() == one.word; });
    if (action == kActions.end()) {
        return usageError(kScheduleCommand, QStringLiteral("write list, arm, disarm, report or rehearse"));
    }
    const auto options = parseStationOptions(arguments.subspan(1), 0);
    if (!options) {
        return usageError(kScheduleCommand, options.error().text);
    }
    const profile::ListenAddress station = options->station.value_or(profile::ListenAddress{});
    local::LocalCommand command = action->command;
    local::LocalAnswer answer = askLocally(station, {.command = command});
    if (answer && command == local::LocalCommand::ScheduleRehearse) {
        command = local::LocalCommand::ScheduleRehearsal;
        answer = awaitRehearsal(station);
    }
    if (answer) {
        printAnswer(command, *answer, options->json);
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
    .arguments = "list|arm|disarm|report|rehearse [--station HOST:PORT] [--format text|json]",
    .summary = "List, arm, disarm or rehearse the schedule of passes of a running station, or show its report",
    .details =
        R"(  list                 shows the chosen passes of the next 24 h, and the passes left out with the reason
  arm                  lets the station track each chosen pass by itself. The station takes control from the clients
  disarm               ends the schedule and the tracking of the present pass. The mount holds
  report               shows the passes so far: seconds tracked, within 1 and 3 dB of the beam, rms and peak error, and
                       how each pass ended
  rehearse             runs the next 24 h in seconds on a copy of the mount, from its present position. Shows the expected
                       report, the used part of the cable, and every warning. Nothing moves
  --station HOST:PORT  the rotctld port of the station. Default: 127.0.0.1:4533
                       HOST is localhost, 127.0.0.1 or ::1: the station runs on this computer
  --format text|json   default: text

The list "watch" of the profile has the satellites with their priorities and lowest elevations. After each start of the
station the schedule is off until somebody arms it, unless schedule.unattended is "on" in the profile. STOP, a fault and
any other command to the mount disarm the schedule.

The command uses the local socket of the station, $XDG_RUNTIME_DIR/boresight/PORT.sock. It works on the computer of the
station, for the user who started the station. The service has the socket /run/boresight/PORT.sock, for root: use sudo.
Exit status: 0 done, 1 the station refused it, 2 the command line is wrong, 3 no station answered in 2 s.

Example:
  boresightctl schedule arm && boresightctl schedule list
)",
    .run = runSchedule};

}  // namespace boresight::ctl
