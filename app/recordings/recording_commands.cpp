// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/subcommand.h"
#include "app/log_output.h"
#include "app/recordings/recording_options.h"
#include "app/recordings/recording_table.h"
#include "core/recording/record_reader.h"

#include <chrono>
#include <optional>
#include <thread>

namespace boresight::ctl {
namespace {

// So many ticks are text at once. An hour of ticks as text would take 150 MB.
constexpr std::size_t kTicksAtOnce = 1'000;

// Names the parts of the file that could not be read.
std::optional<recording::Recording> loadPass(const Subcommand& subcommand, const QString& file)
{
    Result<recording::Recording> loaded = recording::loadRecording(file);
    if (!loaded) {
        complain(subcommand, loaded.error().text);
        return std::nullopt;
    }
    for (const QString& problem : loaded->problems) {
        complain(subcommand, QStringLiteral("%1: %2").arg(file, problem));
    }
    return std::move(*loaded);
}

ExitStatus statusOf(const recording::Recording& pass)
{
    return pass.problems.isEmpty() ? kDone : kFoundWrong;
}

void printTicks(const recording::Recording& pass, TableFormat format)
{
    if (format != TableFormat::Csv) {
        print(tickTable(pass, 0, pass.ticks.size()).text(format));
        return;
    }
    for (std::size_t first = 0; first == 0 || first < pass.ticks.size(); first += kTicksAtOnce) {
        const std::string text = tickTable(pass, first, kTicksAtOnce).text(format);
        print(first == 0 ? text : text.substr(text.find('\n') + 1));
    }
}

ExitStatus runExport(Arguments arguments)
{
    const Result<ExportOptions> options = parseExportOptions(arguments);
    if (!options) {
        return usageError(kExportCommand, options.error().text);
    }
    const auto pass = loadPass(kExportCommand, options->file);
    if (!pass) {
        return kFoundWrong;
    }
    switch (options->part) {
        case RecordedPart::Ticks:
            printTicks(*pass, options->format);
            break;
        case RecordedPart::Events:
            print(eventTable(*pass).text(options->format));
            break;
        case RecordedPart::Plan:
            print(plannedTable(*pass).text(options->format));
            break;
        case RecordedPart::Info:
            print(aboutTable(*pass).text(options->format));
            break;
    }
    return statusOf(*pass);
}

ExitStatus runReplay(Arguments arguments)
{
    const Result<ReplayOptions> options = parseReplayOptions(arguments);
    if (!options) {
        return usageError(kReplayCommand, options.error().text);
    }
    const auto pass = loadPass(kReplayCommand, options->file);
    if (!pass) {
        return kFoundWrong;
    }
    const SteadyTime begin = std::chrono::steady_clock::now();
    for (const ReplayLine& line : replayLines(*pass)) {
        std::this_thread::sleep_until(begin +
                                      std::chrono::duration_cast<SteadyTime::duration>(line.at / options->speed));
        printLine(line.text);
    }
    return statusOf(*pass);
}

}  // namespace

const Subcommand kExportCommand{
    .name = "export",
    .arguments = "FILE [--what ticks|events|plan|info] [--format FORMAT]",
    .summary = "Print the recording of a pass as a table",
    .details =
        R"(  FILE                      a recording. The station keeps them in STATE_DIR/recordings/MOUNT
  --what ticks              the values of each control tick. This is the default
  --what events             the lines of the log during the pass, and the points of the client
  --what plan               the motion of the axes as it was planned before the pass
  --what info               mount, site, target, number of ticks, pointing error
  --format csv|table|json   default: csv

Columns of the ticks: t_utc, then each channel with its unit. An empty cell is unknown.
  state                     of the station, such as TRACK
  actual_, commanded_, target_azimuth_deg and _elevation_deg: directions of the beam
  error_deg                 angle between beam and target
  sensor_, wind_            orientation sensor and wind
  azimuth_, elevation_      of each axis: actual, commanded and target angle with the turns of the cable, rates, torque,
                            current, voltage, power, temperatures, state
Damaged parts of the file are left out and named on standard error.
Exit status: 0 done, 1 the file is no recording, or a part of it is damaged or missing.

Example:
  boresightctl export 20261130T141000Z_NOAA_19.recording > pass.csv
)",
    .run = runExport};

const Subcommand kReplayCommand{
    .name = "replay",
    .arguments = "FILE [--speed 1…60]",
    .summary = "Print a recorded pass as it happened: a status line each second, and the events",
    .details =
        R"(  FILE             a recording. The station keeps them in STATE_DIR/recordings/MOUNT
  --speed NUMBER   so many times faster than it happened, from 1 to 60. Default: 1

A status line has the time, the state, the direction of the beam, the target, and the angle between them.
Exit status: 0 done, 1 the file is no recording, or a part of it is damaged or missing.

Example:
  boresightctl replay 20261130T141000Z_NOAA_19.recording --speed 10
)",
    .run = runReplay};

}  // namespace boresight::ctl
