// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/local_client.h"
#include "app/boresightctl/protocol_lines.h"
#include "app/boresightctl/station_help.h"
#include "app/boresightctl/station_options.h"
#include "app/boresightctl/subcommand.h"

#include <QByteArray>
#include <QThread>

#include <cstdint>

namespace boresight::ctl {
namespace {

constexpr unsigned long kBetweenQuestions = 200;  // ms

// Prints the lines after `last`, and sets `last` to the number of the newest. The numbers themselves are not printed.
Result<> printLinesAfter(std::int64_t& last, const QByteArray& answer)
{
    const auto page = readProtocolPage(last, answer);
    if (!page) {
        return failure(ErrorCode::Protocol, QStringLiteral("the answer of the station is unreadable"));
    }
    if (page->isNewLog) {
        complain(kProtocolLogCommand, QStringLiteral("the station connected again, and its log has begun again"));
    }
    if (page->lost > 0) {
        complain(kProtocolLogCommand, QStringLiteral("lines that are not kept any more: %1").arg(page->lost));
    }
    last = page->last;
    print(page->text);
    return {};
}

// With `follows` until the station ends.
Result<> printLog(const profile::ListenAddress& station, bool follows)
{
    for (std::int64_t last = 0;;) {
        const auto answer = askLocally(station, {.command = local::LocalCommand::ProtocolLines,
                                                 .target = QByteArray::number(static_cast<qlonglong>(last))});
        const Result<> printed =
            answer.and_then([&last](const QByteArray& lines) { return printLinesAfter(last, lines); });
        if (!printed || (answer->isEmpty() && !follows)) {
            return printed;
        }
        if (answer->isEmpty()) {
            QThread::msleep(kBetweenQuestions);
        }
    }
}

Result<> switchLog(const profile::ListenAddress& station, bool on)
{
    const auto command = on ? local::LocalCommand::ProtocolLogOn : local::LocalCommand::ProtocolLogOff;
    return askLocally(station, {.command = command}).map([on](const QByteArray&) {
        printLine(on ? QStringLiteral("The protocol log has begun. It ends with the station.")
                     : QStringLiteral("The protocol log has ended. Its lines stay until the station ends."));
    });
}

ExitStatus runProtocolLog(Arguments arguments)
{
    const auto options = parseStationOptions(arguments, 1);
    if (!options) {
        return usageError(kProtocolLogCommand, options.error().text);
    }
    const std::string& what = options->places.front();
    const profile::ListenAddress station = options->station.value_or(profile::ListenAddress{});
    if (what != "on" && what != "off" && what != "show" && what != "follow") {
        return usageError(
            kProtocolLogCommand,
            QStringLiteral("\"%1\" is none of on, off, show and follow").arg(QString::fromStdString(what)));
    }
    const bool isSwitch = what == "on" || what == "off";
    const Result<> done = isSwitch ? switchLog(station, what == "on") : printLog(station, what == "follow");
    return done ? kDone : failedBy(kProtocolLogCommand, done.error());
}

}  // namespace

const Subcommand kProtocolLogCommand{.name = "protocol-log",
                                     .arguments = "on|off|show|follow [--station HOST:PORT]",
                                     .summary = "Log the lines of all clients of a running station",
                                     .details = kWhichLocalStation + kLocalSocket +
                                                R"(
  on      begin the log. It is off after each start and each reconnect of the station
  off     end the log. Its lines stay
  show    print the newest 2000 lines, oldest first
  follow  print them, and then each new line, until the station ends or Ctrl+C

The columns have tabs between: UTC, client, "odd" or "-", the line as received, what Boresight understood, the answer as
sent. A byte that does not print is \n, \r, \t or \x1b. Long lines are cut. Boresight writes the log to no file: send the
output to one.
)" + kExitStatus + R"(
Example:
  boresightctl protocol-log on
  boresightctl protocol-log follow > protocol.txt
)",
                                     .run = runProtocolLog};

}  // namespace boresight::ctl
