// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/option_reader.h"
#include "app/boresightctl/subcommand.h"
#include "core/base/text.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QProcess>
#include <QStandardPaths>

namespace boresight::ctl {
namespace {

constexpr qsizetype kMostRecordings = 2;

struct ReportOptions
{
    QStringList recordings;
    QString out;
};

Result<ReportOptions> parseReportOptions(Arguments arguments)
{
    ReportOptions options;
    for (; !arguments.empty() && !arguments.front().starts_with("--"); arguments = arguments.subspan(1)) {
        options.recordings << toQString(arguments.front());
    }
    OptionReader reader(arguments);
    while (!reader.atEnd()) {
        const Result<std::string> name = reader.takeName();
        if (!name) {
            return tl::unexpected(name.error());
        }
        const std::optional<std::string> value = reader.takeValue();
        if (*name != "out" || !value || value->empty()) {
            return failure(ErrorCode::InvalidInput, *name == "out"
                                                        ? QStringLiteral("--out needs a file name")
                                                        : QStringLiteral("unknown option --%1").arg(toQString(*name)));
        }
        options.out = toQString(*value);
    }
    if (options.recordings.isEmpty() || options.recordings.size() > kMostRecordings) {
        return failure(ErrorCode::InvalidInput, QStringLiteral("name one recording, or two to compare"));
    }
    if (options.out.isEmpty()) {
        return failure(ErrorCode::InvalidInput, QStringLiteral("--out is missing"));
    }
    return options;
}

// Beside this program, else in PATH. Empty: it is not installed.
QString desktopProgram()
{
    const QString name = QStringLiteral("boresight");
    const QString beside = QStandardPaths::findExecutable(name, {QCoreApplication::applicationDirPath()});
    return beside.isEmpty() ? QStandardPaths::findExecutable(name) : beside;
}

ExitStatus runReport(Arguments arguments)
{
    const Result<ReportOptions> options = parseReportOptions(arguments);
    if (!options) {
        return usageError(kReportCommand, options.error().text);
    }
    const QString program = desktopProgram();
    if (program.isEmpty()) {
        complain(kReportCommand,
                 QStringLiteral("the desktop program \"boresight\" is not installed on this computer, and "
                                "only it draws reports. Install it, or make the report on a computer "
                                "that has it"));
        return kFoundWrong;
    }
    QProcess process;
    process.setProcessChannelMode(QProcess::ForwardedChannels);
    process.start(program, QStringList{QStringLiteral("--report")} + options->recordings +
                               QStringList{QStringLiteral("--out"), options->out});
    if (!process.waitForFinished(-1) || process.exitStatus() != QProcess::NormalExit) {
        complain(kReportCommand, QStringLiteral("%1 failed: %2").arg(program, process.errorString()));
        return kFoundWrong;
    }
    return process.exitCode() == 0 ? kDone : kFoundWrong;
}

}  // namespace

const Subcommand kReportCommand{.name = "report",
                                .arguments = "FILE [FILE2] --out report.pdf|report.png",
                                .summary = "Draw the report of a recorded pass, or compare two passes",
                                .details =
                                    R"(  FILE                 the recording of a pass
  FILE2                a second recording. The report compares both
  --out FILE           the report. A name with .pdf: one page, A4. A name with .png: the same as a picture, 200 dpi

The report has the sky, the pointing error and the torque of both axes over time, a table of numbers, and the events.
The desktop program "boresight" draws it, without a display. It must be installed.
Exit status: 0 done, 1 no report, or parts of a recording could not be read.

Example:
  boresightctl report 20261130T141000Z_NOAA_19.recording --out pass.pdf
)",
                                .run = runReport};

}  // namespace boresight::ctl
