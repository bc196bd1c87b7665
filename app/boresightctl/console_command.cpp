// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/local_client.h"
#include "app/boresightctl/station_help.h"
#include "app/boresightctl/station_options.h"
#include "app/boresightctl/subcommand.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QThread>

namespace boresight::ctl {
namespace {

// The box has 0.8 s for its answer, and may have to finish another exchange first.
constexpr std::chrono::seconds kAnswerPatience{5};
constexpr unsigned long kBetweenTexts = 100;  // ms

// The typed lines and the answers that the station has kept.
Result<QStringList> readConsole(const profile::ListenAddress& station)
{
    return askLocally(station, {.command = local::LocalCommand::ConsoleLines}).map([](const QByteArray& answer) {
        QStringList lines;
        for (const QJsonValue& line : QJsonDocument::fromJson(answer).array()) {
            lines << line.toString();
        }
        return lines;
    });
}

// The lines after the last typed line. Empty: the answer is still awaited.
QStringList answerIn(const QStringList& lines, const QStringList& before)
{
    qsizetype typed = lines.size() - 1;
    while (typed >= 0 && !lines[typed].startsWith(QStringLiteral("> "))) {
        --typed;
    }
    return lines == before ? QStringList() : lines.mid(typed + 1);
}

Result<QStringList> awaitAnswer(const profile::ListenAddress& station, const QStringList& before)
{
    for (const QDeadlineTimer deadline(kAnswerPatience); !deadline.hasExpired();) {
        const auto lines = readConsole(station);
        if (!lines) {
            return lines;
        }
        if (QStringList answer = answerIn(*lines, before); !answer.isEmpty()) {
            return answer;
        }
        QThread::msleep(kBetweenTexts);
    }
    return failure(ErrorCode::Refused, QStringLiteral("the line was accepted, but the station has shown no answer"));
}

ExitStatus runConsole(Arguments arguments)
{
    const auto options = parseConsoleOptions(arguments);
    if (!options) {
        return usageError(kConsoleCommand, options.error().text);
    }
    std::string line;
    for (const std::string& word : options->places) {
        line += (line.empty() ? "" : " ") + word;
    }
    const profile::ListenAddress station = options->station.value_or(profile::ListenAddress{});
    const local::LocalRequest typed{.command = local::LocalCommand::TypeLine,
                                    .target = QByteArray::fromStdString(line)};
    const auto answer = readConsole(station).and_then([&](const QStringList& before) {
        return askLocally(station, typed).and_then([&](const QByteArray&) { return awaitAnswer(station, before); });
    });
    if (!answer) {
        return failedBy(kConsoleCommand, answer.error());
    }
    print(answer->join(u'\n').toStdString() + '\n');
    return kDone;
}

}  // namespace

const Subcommand kConsoleCommand{.name = "console",
                                 .arguments = "LINE [--station HOST:PORT]",
                                 .summary = "Type a line to the control box of a running station",
                                 .details = kWhichLocalStation + kLocalSocket +
                                            R"(
LINE is sent to a GS-232 box or an ESP32 relay controller as it is, like on the page Mount, Console of the window. The
command prints the answer of the box, or that there is none.

The station refuses a line while the mount moves, while it tracks a target, and while the box does not answer. It refuses
lines that are known to move the rotator. Other lines are not checked, so watch the mount. A stop follows each line. The
operator has control afterwards. The command release gives control back to the clients.
)" + kExitStatus + R"(
Example:
  boresightctl console H
  boresightctl console CALSTATS
)",
                                 .run = runConsole};

}  // namespace boresight::ctl
