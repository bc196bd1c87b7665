// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/local_client.h"
#include "app/boresightctl/record_table.h"
#include "app/boresightctl/sky_time.h"
#include "app/boresightctl/station_help.h"
#include "app/boresightctl/station_options.h"
#include "app/boresightctl/subcommand.h"
#include "core/base/clock.h"
#include "core/base/numbers.h"
#include "core/targets/target_text.h"

#include <QFileInfo>
#include <QStringList>

#include <vector>

namespace boresight::ctl {
namespace {

using Days = std::chrono::duration<double, std::chrono::days::period>;

constexpr int kAgeDecimals = 2;

// The station needs some seconds for a file of 100 MB.
constexpr std::chrono::seconds kFilePatience{60};

// The path of a file is made absolute, because the station runs in another folder.
Result<QByteArray> sent(const std::string& target)
{
    const auto file = targets::tableFile(target);
    const QByteArray text =
        file ? "table " + QFileInfo(*file).absoluteFilePath().toUtf8() : QByteArray::fromStdString(target);
    if (text.contains('\n')) {
        return failure(ErrorCode::InvalidInput, QStringLiteral("a target is one line"));
    }
    return text;
}

ExitStatus runTrack(Arguments arguments)
{
    const auto options = parseTrackOptions(arguments);
    if (!options) {
        return usageError(kTrackCommand, options.error().text);
    }
    std::string target;
    for (const std::string& word : options->places) {
        target += (target.empty() ? "" : " ") + word;
    }
    const auto text = sent(target);
    if (!text) {
        return usageError(kTrackCommand, text.error().text);
    }
    const auto answer = askLocally(
        options->station.value_or(profile::ListenAddress{}), {.command = local::LocalCommand::Track, .target = *text},
        targets::tableFile(target) || targets::otherRotator(target) ? kFilePatience : kPatience);
    if (!answer) {
        return failedBy(kTrackCommand, answer.error());
    }
    printLine(QStringLiteral("The station tracks %1. The operator has control: clients are refused until release.")
                  .arg(QString::fromUtf8(answer->trimmed())));
    return kDone;
}

RecordTable tableOf(const std::vector<local::KnownSatellite>& satellites, UtcTime now)
{
    RecordTable table{.columns = {{"name"}, {"norad", true}, {"epoch_utc"}, {"age_days", true}}};
    for (const local::KnownSatellite& one : satellites) {
        table.rows.push_back({one.name.toStdString(), std::to_string(one.number), skyTimeText(one.epoch, 0),
                              formatFixed(Days(now - one.epoch).count(), kAgeDecimals)});
    }
    return table;
}

ExitStatus runSatellites(Arguments arguments)
{
    const auto options = parseSatellitesOptions(arguments);
    if (!options) {
        return usageError(kSatellitesCommand, options.error().text);
    }
    const auto satellites = askLocally(options->station, {.command = local::LocalCommand::Satellites})
                                .and_then([](const QByteArray& lines) { return local::parseSatellites(lines); });
    if (!satellites) {
        return failedBy(kSatellitesCommand, satellites.error());
    }
    print(tableOf(*satellites, SystemClock().utc()).text(options->format));
    if (satellites->empty()) {
        complain(kSatellitesCommand, QStringLiteral("The station knows no satellites. Name a file or folder with "
                                                    "elements in the setting elements of its profile."));
        return kFoundWrong;
    }
    return kDone;
}

}  // namespace

const Subcommand kTrackCommand{.name = "track",
                               .arguments = "TARGET [--station HOST:PORT]",
                               .summary = "Let a running station track a satellite, a body or a place",
                               .details = kWhichLocalStation +
                                          R"(
TARGET is one of these. Capital and small letters are the same.
  25544, noaa 19, iss         a satellite that the station knows: its number, its name, or words found only in its name
  sun, moon, mercury, venus, mars, jupiter, saturn, uranus, neptune
  cas-a, cyg-a, tau-a, vir-a, sgr-a   radio sources
  radec HOURS,DEGREES         a place among the stars: J2000, each as a number or like 12:30:49.4
  azel AZIMUTH,ELEVATION      a fixed direction, in degrees
  IM58kr                      the bearing to a Maidenhead locator. "IM58kr long": the long path
  place NORTH,EAST,HEIGHT     a position in degrees and metres above the ellipsoid of WGS-84
  table FILE, oem FILE        the path in a file: a tracking table with a time, an azimuth and an elevation in each line, or a
                              CCSDS OEM as KVN or XML. The user of the station must be able to read the file.
                              "ephemeris --table FILE" shows the path
  rotctld:HOST:PORT           where another rotator points, as its rotctld reports
  azel.dat                    the Moon of WSJT-X, MAP65 or QMAP (settings of azel)
  position                    the balloon or rocket whose positions the station receives (settings of position)
)" + kLocalSocket +
                                          R"(
The command ends when the station has accepted the target. The motion continues. The mount tracks a target that rises and
sets until the target sets. Then the mount holds. A table rises and sets with its ends, too. The mount waits for a target
that rises within 30 minutes. For any other target below the horizon the station reports when it rises. The mount goes to
a direction or a place and stays there.

The station refuses the command while STOP is latched, and while a client has control. In that case use take first. The
operator has control afterwards. The command release gives control back to the clients and ends the tracking. The Sun is
refused while the profile keeps the beam away from the Sun.
)" + kExitStatus +
                                          R"(
Example:
  boresightctl track moon
  boresightctl track iss
)",
                               .run = runTrack};

const Subcommand kSatellitesCommand{.name = "satellites",
                                    .arguments = "[--station HOST:PORT] [--format FORMAT]",
                                    .summary = "List the satellites that a running station knows",
                                    .details = kWhichLocalStation +
                                               R"(  --format csv|table|json   default: csv
)" + kLocalSocket + R"(
Columns: name,norad,epoch_utc,age_days, in the order of the numbers. The age is the present age of the elements,
by the clock of this computer. The setting elements of the profile names the files that the station reads.
)" + kExitStatus + R"(
Example:
  boresightctl satellites --format table
)",
                                    .run = runSatellites};

}  // namespace boresight::ctl
