// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/local_client.h"
#include "app/boresightctl/record_table.h"
#include "app/boresightctl/station_help.h"
#include "app/boresightctl/station_options.h"
#include "app/boresightctl/subcommand.h"
#include "core/base/numbers.h"

namespace boresight::ctl {
namespace {

constexpr int kAntennaDecimals = 3;

RecordTable tableOfAntennas(const std::vector<local::KnownAntenna>& antennas)
{
    const auto number = [](Angle angle) { return formatFixed(angle.degrees(), kAntennaDecimals); };
    RecordTable table{
        .columns = {
            {"name"}, {"beam_width_deg", true}, {"offset_across_deg", true}, {"offset_up_deg", true}, {"in_use"}}};
    for (const local::KnownAntenna& one : antennas) {
        table.rows.push_back({one.antenna.name, number(one.antenna.beamWidth), number(one.antenna.across),
                              number(one.antenna.up), one.isInUse ? "yes" : "no"});
    }
    return table;
}

ExitStatus listAntennas(const StationOptions& options)
{
    const auto antennas =
        askLocally(options.station.value_or(profile::ListenAddress{}), {.command = local::LocalCommand::Antennas})
            .and_then([](const QByteArray& lines) { return local::parseAntennas(lines); });
    if (!antennas) {
        return failedBy(kAntennaCommand, antennas.error());
    }
    print(tableOfAntennas(*antennas).text(options.json ? TableFormat::Json : TableFormat::Table));
    return kDone;
}

ExitStatus useAntenna(const StationOptions& options)
{
    std::string name;
    for (const std::string& word : options.places) {
        name += (name.empty() ? "" : " ") + word;
    }
    const auto answer =
        askLocally(options.station.value_or(profile::ListenAddress{}),
                   {.command = local::LocalCommand::UseAntenna, .target = QByteArray::fromStdString(name)});
    if (!answer) {
        return failedBy(kAntennaCommand, answer.error());
    }
    printLine(QStringLiteral("Antenna \"%1\" is in use. All directions are those of its beam.")
                  .arg(QString::fromStdString(name)));
    return kDone;
}

ExitStatus runAntenna(Arguments arguments)
{
    const auto options = parseAntennaOptions(arguments);
    if (!options) {
        return usageError(kAntennaCommand, options.error().text);
    }
    return options->places.empty() ? listAntennas(*options) : useAntenna(*options);
}

}  // namespace

const Subcommand kAntennaCommand{.name = "antenna",
                                 .arguments = "[NAME] [--station HOST:PORT] [--format text|json]",
                                 .summary = "List the antennas of a running station, or use one of them",
                                 .details = kWhichLocalStation +
                                            R"(  --format text|json   form of the list. Default: text

NAME is "main" or the name of an [[antenna]] of the profile, with the same capital and small letters. Without NAME
the antennas are listed.
)" + kLocalSocket + R"(
Columns: name,beam_width_deg,offset_across_deg,offset_up_deg,in_use.

All directions are those of the beam of the antenna in use. The axes stand still, unless the station tracks a target by
itself. Then the beam of the chosen antenna moves to the target. The station refuses another antenna while a client
moves the mount, and while the mount moves to a target. After a start of the station the antenna "main" is in use.
)" + kExitStatus + R"(
Example:
  boresightctl antenna
  boresightctl antenna 70 cm
)",
                                 .run = runAntenna};

}  // namespace boresight::ctl
